// Blows of a force, and what the motion of their DOF says of them.
#pragma once
#include "host_sim/data_check/spikes/gaps.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

// Of the momentum that blows should have brought, the share that the motion shows: 1 where they acted, 0 where the sensor alone had them.
struct Answered {
  double share = 1.0, std = 0.0;  // 0: nothing tells
};

// blows: stretches of `force` that stand off what is around them; velocity_step: what a sample of 1 N changes the velocity by, sample
// period over mass. Of the channels of the DOF, and the times that they are given, the one that tells it best, to a tenth at least; its
// scatter away from the blows is the deviation. One that shows them all the same goes before: a sensor may
// be late.
Answered answered(const Record& record, const Channel& force, const std::vector<Gap>& blows, double velocity_step);

}  // namespace host_sim::data_check
