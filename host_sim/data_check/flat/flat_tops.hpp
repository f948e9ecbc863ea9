// What is cut off at both ends of a channel's range; the rules are in clipping.hpp.
#pragma once
#include "host_sim/data_check/flat/tops.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

constexpr double kFaultShare = 0.002;  // of all samples; below it estimates suffer less than their intervals

struct FlatTops {
  Tops top, bottom;
  bool amid_noise = false, at_limit = false;
};

// record: what stands beside the channel; may be missing. Limits: the converter's ends in SI; equal where they are not known.
FlatTops flat_tops(const Channel& channel, const Record* record, const Statistics& statistics, double lower_limit,
                   double upper_limit);

}  // namespace host_sim::data_check
