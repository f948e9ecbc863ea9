// The part of a record between two instants.
#pragma once
#include <limits>

#include "host_sim/records/record.hpp"

namespace host_sim {

// In the file's own seconds, as every message says them. Both ends belong to it.
struct TimeSpan {
  double from_s = -std::numeric_limits<double>::infinity();
  double to_s = std::numeric_limits<double>::infinity();
  bool is_all() const { return from_s == TimeSpan().from_s && to_s == TimeSpan().to_s; }
};

// The record's samples within the span; what was taken stands in its notes. Throws DataFileError where fewer than two are.
Record within(Record record, const TimeSpan& span);

}  // namespace host_sim
