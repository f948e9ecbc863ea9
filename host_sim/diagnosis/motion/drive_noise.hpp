// What noise of the channels that drive a rig makes of its simulated motion.
#pragma once
#include <random>

#include "prepared.hpp"

namespace diagnosis::runs {

// Copies of records whose forces and bases carry another white noise of the same level beside their own; between blows none.
class DriveNoise {
 public:
  Prepared added_to(const Prepared& record);

 private:
  void disturb(const Vec& sigma, Vec& y);
  std::mt19937_64 random_{1};
  std::normal_distribution<double> normal_;
};

// The largest lasting error of a DOF's force: what makes much noise is not right on the mean either. 0 where it is a sound
// instrument.
double lasting_error_of_force(const Prepared& record, size_t dof);
bool drives_are_much_noise(const std::vector<Prepared>& records);

bool drives_have_noise(const std::vector<Prepared>& records);

}  // namespace diagnosis::runs
