// Stretches of a channel that are flat at one level, and what is cut off there.
#pragma once
#include <cstddef>
#include <vector>

#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {

struct Tops {
  size_t samples = 0, runs = 0, longest = 0;
  // Of those within the record that are entered or left with some speed: a rig that rests sheds it before, and one that is still to be
  // driven, or has been, rests at the record's ends.
  size_t longest_cut = 0;
  double missing =
      0.0;  // mean height that is cut off the longer runs, by the slopes with which they are entered and left
  std::vector<Run> where;
};

// Stretches of two and more samples within `band` of the level. sign +1: the level is the highest value; -1: the lowest.
std::vector<Run> runs_at(const std::vector<double>& values, double level, double band, double sign);

// Of these stretches. seen: what noise and steps let one see of a slope.
Tops tops_at(const std::vector<double>& values, const std::vector<Run>& runs, double sign, double seen);

}  // namespace host_sim::data_check
