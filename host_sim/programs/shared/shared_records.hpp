// Records that are looked at from two sides at once; whoever changes them has his own from then on.
#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

class SharedRecords {
 public:
  explicit SharedRecords(std::vector<Record> records)
      : records_(std::make_shared<std::vector<Record>>(std::move(records))) {}

  const std::vector<Record>& get() const { return *records_; }
  // As they are now, whatever becomes of these. To be let go in the thread that calls own().
  std::shared_ptr<const std::vector<Record>> as_they_are() const { return records_; }
  // To change: copied where somebody still holds them as they were. What get() has given may be others' from then on.
  std::vector<Record>& own() {
    if (records_.use_count() > 1) records_ = std::make_shared<std::vector<Record>>(*records_);
    return *records_;
  }

 private:
  std::shared_ptr<std::vector<Record>> records_;
};

}  // namespace host_sim
