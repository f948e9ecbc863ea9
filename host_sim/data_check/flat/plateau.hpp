// Motion that is held, told from a range that ends: the other channels of a record know which of both a flat stretch is.
#pragma once
#include <vector>

#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

// What stands beside one channel. The record outlives it.
class Witnesses {
 public:
  Witnesses(const Record& record, const Channel& channel);

  // Whether the motion itself stays within 1.5 bands on that stretch, which the channel shows flat within `band`.
  // By its derivative where one is recorded: what its integral climbs is what is cut off. Else by the forces: they stand
  // still on the stretch and move at both of its ends, as a drive does that ramps a speed up, holds it and takes it back;
  // of a rig that swings freely behind a blow they tell nothing. False where nothing tells of it.
  bool hold(const Run& run, double band) const;

 private:
  struct Witness {
    const Channel* channel = nullptr;
    Statistics statistics;
  };
  bool stands_still(const Witness& force, const Run& run) const;

  double sample_period_s_;
  std::vector<Witness> derivatives_, forces_;
};

}  // namespace host_sim::data_check
