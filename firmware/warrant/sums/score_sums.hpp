// The per-sample side of the score tests: takes blocks out of the stream and works through the probes, at most a budget
// of products a sample. Where the budget is short, blocks are left out between two that are worked on, a random number of
// them, so that a periodic motion is met at every phase.
#pragma once
#include "firmware/warrant/probes/probe_budget.hpp"
#include "firmware/warrant/probes/probe_force.hpp"
#include "firmware/warrant/probes/shared_noise.hpp"
#include "firmware/warrant/sums/score_table.hpp"

namespace firmware {

class ScoreSums {
 public:
  // effect_unit: SI unit of every effect term's column, in the order of the terms. budget: products a sample, 0 none.
  void configure(const CoreConfiguration& configuration, const Scaled* effect_unit, const ClearSigns& signs);
  void clear();
  void begin_level();
  void restart();  // a gap: what comes does not follow what came
  // The frame's block of count samples has its columns filled.
  void offer(const Frame& frame, int count);
  void work() {  // once a sample
    table_.advance();
    if (busy_ && (credit_ += budget_.products()) >= needed_) go_on();
  }
  bool merging() const { return table_.merging(); }
  void flush() {  // the table is about to be read
    table_.flush();
    table_.settle();
  }
  void finish();  // the block that is being worked on, and the exact sums, go into the table

  const ProbePlan& plan() const { return plan_; }
  const ScoreTable& table() const { return table_; }
  uint64_t offered() const { return offered_; }  // samples, looked at or not
  // SI unit of a probe's sums, per equation, per column of its place, of its own force, and of its slopes.
  Scaled unit(const Probe& probe, int value) const;
  Scaled force_unit(const Probe& probe) const;
  // What noise adds to the sum with an equation's known part or a column, per unit of a slope's sum; SI.
  Scaled noise_share(const Probe& probe, int slope, int value, SharedNoise::Of of) const;

 private:
  void start_block();
  void forget_squares();
  void measure_scales();
  void set_noise();
  void grow_scale(int place);
  bool outgrown() const;
  void go_on();
  uint32_t cost(const Probe& probe) const;
  void work_on(const Probe& probe);
  void end_block();

  // The small ones first: a short instruction reaches them.
  const CoreConfiguration* configuration_ = nullptr;
  uint8_t scale_blocks_ = 0;
  bool busy_ = false;
  int16_t next_ = 0;  // in order_
  int motion_place_ = -1;
  uint32_t credit_ = 0;             // products that may be done
  uint32_t needed_ = 0;             // for the next probe, with what its block took before it
  uint32_t skip_ = 0, random_ = 1;  // blocks to leave out
  uint64_t offered_ = 0;
  uint32_t time_ = 0, block_time_ = 0;  // samples since the level's start
  ProbeBudget budget_;
  ProbePlan plan_;
  uint16_t order_[kMaxProbes];  // by place
  uint8_t unknown_column_[kMaxUnknowns];
  BlockMotion block_;
  SharedNoise noise_;
  ScoreTable table_;
  PlaceScale scale_[kMaxPlaces];
  int64_t square_[kMaxPlaces][2];    // of the smoothed quantities, Q20 of the range, over scale_blocks_
  int64_t noise_square_[kMaxNodes];  // of (6 v - instrument), codes
  PlaceMotion motion_;
};

}  // namespace firmware
