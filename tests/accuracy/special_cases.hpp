// Measurements that are not a table of parameters: skew, sensor sets, and advice that is followed.
#pragma once
#include <string>
#include <vector>

#include "host_sim/plant/scenario/scenario.hpp"

namespace accuracy {

// paper_3dof_random with 5 % noise, 10 s a level, all displacements late by 250 us.
struct SkewMeasurement {
  std::vector<double> mean_us, deviation_us;  // per DOF
  std::vector<double> bound_us;               // Cramer-Rao bound of the deviation, per DOF
  double within_15_us_percent = 0.0;          // share of all measurements
  double marked_percent = 0.0;                // share of draws in which some parameter is SKEWED
  std::vector<double> error_before_percent,
      error_after_percent;  // mean error per unknown, uncompensated and compensated
};
SkewMeasurement measure_skew(int draws);

// paper_3dof_random at 0.1 % noise with force and one quantity only: largest error of a viscous coefficient over the
// draws.
struct SensorSet {
  std::string name;
  double worst_viscous_percent = 0.0, worst_coulomb_percent = 0.0;
  int not_valid = 0;
};
std::vector<SensorSet> measure_sensor_sets(int draws);

// paper_3dof_one_frequency, then the same with the advised frequency in place of its second level.
struct FollowedAdvice {
  int ill_conditioned_clean = 0,
      ill_conditioned_noisy = 0;  // unknowns; draws in which the first viscous unknown is so marked
  int draws = 0;
  double advised_Hz = 0.0;
  double error_after_percent = 0.0;  // worst, clean
  int valid_after = 0;               // unknowns VALID, clean
};
FollowedAdvice follow_advice(int draws);

}  // namespace accuracy
