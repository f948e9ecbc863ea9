// What of the forces and accelerations of a record goes with one of the forces that drive it, bin by bin: means over segments, in which
// the channels' noise has no part.
#pragma once
#include "../motion/prepared.hpp"
#include "../record/fourier.hpp"

namespace diagnosis::runs {

struct CrossSpectra {
  Vec hertz;                                          // of each bin, the mean left out of use
  Vec power;                                          // of the drive
  std::vector<Eigen::VectorXcd> force, acceleration;  // per DOF; a force that is not measured: empty
};

// One for each force of the record that is not nought all along. Empty: the record is too short.
std::vector<CrossSpectra> cross_spectra(const Prepared& record);

}  // namespace diagnosis::runs
