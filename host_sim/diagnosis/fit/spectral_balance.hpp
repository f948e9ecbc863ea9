// The balance of forces of every DOF, bin by bin: as much of it as goes with what drives the rig. Noise of the channels of motion has no
// part in it, and no simulation is needed: first values, and a hidden mode's place, where no window is followed.
#pragma once
#include <optional>

#include "../record/fourier.hpp"
#include "../simulate/model.hpp"

namespace diagnosis::runs {

// Sum over the unknown numbers of number times column = given, in N per root of a drive's power. Complex.
struct SpectralBalance {
  std::vector<size_t> numbers;         // places in the model: masses, springs and dampers that are unknown
  std::vector<int> dof;                // of each row, from 0
  Vec hertz;                           // of each row
  Eigen::MatrixXcd columns;            // rows x numbers
  Eigen::VectorXcd given;              // force less what is known
  Eigen::VectorXcd mode_acceleration;  // of the row's DOF, which carries a hidden mode
};

// No rows where no force drives the rig, or a moving base does. Friction and laws that are not linear have no part in it.
SpectralBalance spectral_balance(const System& system, const std::vector<Prepared>& records, const Model& model);

struct HiddenMode {
  int dof = 0;  // from 0
  double resonance_Hz = 0, damping_ratio = 0, mass_kg = 0;
  Vec numbers;      // the rig's own beside it, as SpectralBalance has them
  double left = 1;  // of the squared balance that the rig alone leaves
};
// The mode on a DOF that leaves the least, of positive mass beside positive masses and springs.
std::optional<HiddenMode> hidden_mode(const SpectralBalance& balance, const Model& model);

}  // namespace diagnosis::runs
