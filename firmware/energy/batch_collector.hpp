// Collects batches level by level into the table, merging neighbours when a level's table is full.
#pragma once
#include "firmware/energy/batch_table.hpp"

namespace firmware {

// Time is counted in units: a sixteenth of a cycle (or the half, quarter ... of one, where that is over 1024 samples) for
// whole cycles, batch_samples otherwise. A batch is 2^merges units, so that with four merges every batch is whole cycles.
// Merging is spread over the samples of the batch that comes next, so that no single sample bears it.
class BatchCollector {
 public:
  explicit BatchCollector(BatchTable& table) : table_(table) {}
  void clear(const CoreConfiguration& configuration, const RowLayout& layout);
  void begin_level();
  bool level_open() const { return open_; }
  bool refused() const { return refused_; }  // a level was begun with the table full: its data are not used

  uint32_t unit_end(uint32_t unit) const;  // samples from the level's start to the end of this many units
  // Before a long level's units have no room: whole cycles are taken off what has been counted of units, and of samples, which
  // wrap.
  void count_anew(uint32_t& units, uint32_t& samples) const;
  // The next call of add() should bring this many units, at the most; or the call after one that brings `units`.
  uint32_t units_wanted(uint32_t units = 0) const;
  void add(const Batch& batch, uint32_t units);  // in the order of time; units 0: an incomplete one
  // Once for each sample: the next share of a merge that is under way.
  void advance() {
    if (merging_) merge_some();
  }
  // Finishes it at once, which takes about as long as a hundred batches: before the table is read or a level ends.
  void settle();
  bool merging() const { return merging_; }
  void mark_saturated();
  // Whole cycles: what follows the last whole cycle is dropped, unless there was not even one.
  void end_level();

 private:
  void append(const Batch& batch);
  void merge_some();
  void merge_part();
  void keep_whole_cycles();
  uint32_t batch_units() const;  // of the batch that is being collected
  Level& level() { return table_.level[table_.level_count - 1]; }
  const Level& level() const { return table_.level[table_.level_count - 1]; }

  BatchTable& table_;
  bool merging_ = false;
  bool periodic_ = false, open_ = false, refused_ = false, incomplete_ = false;
  int merged_ = 0, part_ = 0, parts_per_sample_ = 1;
  uint32_t pending_units_ = 0, table_units_ = 0;
  uint32_t unit_numerator_ = 32, unit_denominator_ = 1;  // samples per unit
  uint32_t units_per_cycle_ = 16;
  Batch pending_;
  Batch held_;  // came when the table was full: goes in once its pairs are merged
};

// a + b, entry by entry; both over the same layout and adjoining in time.
void accumulate(Batch& a, const Batch& b, const RowLayout& layout);
// What the layout uses of a batch; the rest of `to` stays as it is.
void copy_used(Batch& to, const Batch& from, const RowLayout& layout);

}  // namespace firmware
