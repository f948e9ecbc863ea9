// Sums of every probe over stretches of the record, for all levels together: what the score tests are worked out from at
// the end of a window, with the estimates of that very window.
//
// Per probe: sum of phi times the known part of each of its equations, of phi times every unknown's column there, and of
// phi times its own force. Formats: phi below 2^24, columns below 2^27, 31 samples a block, 32 blocks at the most before
// the exact int64 sum (2^61) goes into the table, whose numbers have an exponent (pack(): 2^-47).
// The exact sums of a place count in its scale (sum_exponents.hpp), which may grow: what they hold so far is then shifted to the new
// one and rounded to nearest, half a unit of one product at the most. The table's numbers do not know of it.
//
// Room is fixed: a rig with few probes gets up to 256 stretches, one with many fewer, at least 16. Where the table is
// full, neighbouring stretches of each level merge and the length of a stretch doubles: nothing is lost. That is up to 32768
// additions, so a slice of them is done with each sample; the sums of the blocks that filled the table are held meanwhile.
#pragma once
#include "firmware/configuration/capacity.hpp"
#include "firmware/fixed_point/short_scaled.hpp"
#include "firmware/warrant/sums/sum_exponents.hpp"

namespace firmware {

constexpr int kFewestStretches = kMostStretches < 16 ? kMostStretches : 16;
constexpr int kMostProbeValues = kWarrantNumbers / kFewestStretches;
constexpr int kExactBlocks = 32;

struct Stretch {
  uint8_t level = 0;
  uint32_t blocks = 0;
  uint64_t time = 0;  // sum over its blocks of their samples since the level's start
};

class ScoreTable {
 public:
  // scale: of each place of the plan, as it is when sums go into the table. No plan: sums are whole numbers.
  void configure(int values, const ProbePlan* plan, const PlaceScale* scale);
  void clear();
  void begin_level();
  // Exact sums of the block that is being worked on; add_block() closes it.
  int64_t& current(int value) { return current_[value]; }
  void add_block(uint32_t time_samples);
  // The value's exact sums count in 2^bits of what they have counted in.
  void rescale(int value, int bits);
  void advance() {  // once a sample: goes on with a merge
    if (merging_) merge_some(numbers_per_sample_);
  }
  bool merging() const { return merging_; }       // flush() would end it at once
  void flush();                                   // the exact sums go into the table
  void settle() { merge_some(kWarrantNumbers); }  // ends a merge: value() can be read

  int stretches() const { return count_; }
  int levels() const { return level_; }
  const Stretch& stretch(int s) const { return stretch_[s]; }
  ShortScaled number(int s, int value) const { return number_at(place(s, value)); }
  Scaled value(int s, int value) const;
  // Over stretches [from, to), exact to 2^-53 of the largest of them.
  Scaled sum(int from, int to, int value) const;
  // The value's numbers of all stretches, one after the other.
  const int32_t* mantissas(int value) const { return mantissa_ + place(0, value); }
  const int8_t* exponents(int value) const { return exponent_ + place(0, value); }

 private:
  struct Row {  // of the merged table: made of one stretch, or of it and the next one
    uint16_t from = 0;
    bool pair = false;
  };
  void close_stretch();
  void drop();
  void begin_merge();
  void merge_some(int numbers);
  void end_merge();
  void append_row();
  void add_exact(const int64_t* sums);
  int place(int s, int value) const { return value * room_ + s; }
  ShortScaled number_at(int at) const { return {mantissa_[at], exponent_[at]}; }
  void put(int at, ShortScaled number) {
    mantissa_[at] = number.mantissa;
    exponent_[at] = static_cast<int8_t>(number.exponent);  // whole numbers of 2^-84, below 2^140
  }
  void add_to(int at, int64_t sum, int exponent) { put(at, number_at(at) + short_scaled(sum, exponent)); }

  const ProbePlan* plan_ = nullptr;
  const PlaceScale* scale_ = nullptr;
  // The small ones first: a short instruction reaches them.
  int values_ = 0, room_ = 0, count_ = 0, level_ = 0;
  bool open_ = false;     // the last stretch is of this level and not yet full
  uint32_t length_ = 1;   // blocks of a stretch
  uint32_t pending_ = 0;  // blocks in the exact sums
  uint64_t pending_time_ = 0;
  // A merge: stretch_ and count_ are those of the merged table from its beginning, its numbers only at its end.
  bool merging_ = false;
  int numbers_per_sample_ = 0;
  int rows_ = 0, row_ = 0, next_value_ = 0;  // rows to merge, the one at hand, and how far it is
  bool held_in_new_row_ = false;             // held_ opens the stretch after them, else it goes on with the last one

  Row merged_[kMostStretches];
  Stretch stretch_[kMostStretches];
  int64_t current_[kMostProbeValues], held_[kMostProbeValues];
  int32_t mantissa_[kWarrantNumbers];
  int8_t exponent_[kWarrantNumbers];
};

}  // namespace firmware
