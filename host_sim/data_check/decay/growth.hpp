// Motion that grows by itself: what drives the rig is not in the recording.
#pragma once
#include <optional>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

constexpr size_t kGrowthParts = 10;

// Of each tenth, about its mean. A speed that keeps its sign (a car that rolls, a flywheel) has its energy about zero: how it varies
// within a tenth is how it is braked.
std::vector<double> mean_squares_of_tenths(const Channel& channel);

// The longest growth from part to part: twice in succession half as much again, four times in all.
struct Growth {
  size_t from = 0, to = 0;  // parts
  double times = 0.0;       // 0: there is none
};
Growth growth_of(const std::vector<double>& squares);

// Of a record of one DOF without a force and without a moving base. A rig that nobody pushes only loses energy, so the
// mean square of its motion about the mean of each tenth of the record falls from tenth to tenth, or begins where it is let
// go. A fault where it is half as much again twice in succession and four times as much in all: a release in the
// middle of a tenth raises it once, and so does a blow. Nothing is said of a record of fewer than ten periods.
std::optional<Finding> find_growth(const Record& record);

}  // namespace host_sim::data_check
