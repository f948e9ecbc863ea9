// The balance of forces of every DOF, bin by bin: as much of it as goes with what drives the rig. Noise of the channels of motion has no
// part in it, and no simulation is needed: first values, and a hidden mode's place, where no window is followed.
#pragma once
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

// No rows where neither a force nor a base drives the rig, or the DOFs are known against the base alone. Friction and laws that are not linear have no part in it.
SpectralBalance spectral_balance(const System& system, const std::vector<Prepared>& records, const Model& model);

// The model with these numbers, one for each of the balance's.
Model with_numbers(const SpectralBalance& balance, const Vec& numbers, Model model);

}  // namespace diagnosis::runs
