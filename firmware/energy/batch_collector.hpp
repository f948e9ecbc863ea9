// Collects batches level by level into the table, merging neighbours when a level's table is full.
#pragma once
#include "firmware/energy/batch_table.hpp"

namespace firmware {

class BatchCollector {
 public:
  explicit BatchCollector(BatchTable& table) : table_(table) {}
  void clear(const CoreConfiguration& configuration, const RowLayout& layout);
  void begin_level();
  bool level_open() const { return open_; }
  bool refused() const { return refused_; }  // a level was begun with the table full: its data are not used
  uint32_t batch_length() const;    // samples that a batch of the open level has now
  void add(const Batch& batch);     // in the order of time; adds to the pending batch until that has the level's length
  void mark_saturated();
  void end_level();

 private:
  void append(const Batch& batch);
  BatchTable& table_;
  Batch pending_;
  uint32_t first_length_ = 0;
  bool periodic_ = false, open_ = false, refused_ = false;
};

// a + b, entry by entry; both over the same layout and adjoining in time.
void accumulate(Batch& a, const Batch& b, const RowLayout& layout);

}  // namespace firmware
