// By how much a record may be thinned out.
#pragma once
#include "../motion/prepared.hpp"

namespace diagnosis::runs {

struct Thinning {
  int by = 1;         // of so many samples one is left
  double top_Hz = 0;  // highest frequency of the motion
};
Thinning thinning_of(const rig_file::RigModel& rig, const host_sim::Record& record);

Vec values_of(const host_sim::Channel& channel);

}  // namespace diagnosis::runs
