// What of the forces and accelerations of a record goes with one of the forces that drive it, or with its base, bin by bin: means over segments, in which
// the channels' noise has no part.
#pragma once
#include "../motion/prepared.hpp"
#include "../record/fourier.hpp"

namespace diagnosis::runs {

struct CrossSpectra {
  Vec hertz;  // of each bin, the mean left out of use
  Vec power;  // of the drive
  bool of_base = false;
  std::vector<Eigen::VectorXcd> force;         // per DOF; not measured: empty
  std::vector<Eigen::VectorXcd> acceleration;  // per DOF; a base that moves: after the last one
  std::vector<Vec> acceleration_power;         // whether it goes with the drive or not
  // Largest share of a DOF's power that goes with the drive.
  double coherence(Index bin) const;
};

// One for each force of the record that is not nought all along, and one for a base that moves. Empty: the record is too short.
std::vector<CrossSpectra> cross_spectra(const Prepared& record);

}  // namespace diagnosis::runs
