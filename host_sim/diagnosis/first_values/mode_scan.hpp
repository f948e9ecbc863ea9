// A mode that the rig file lacks, over the frequencies of the balance of forces.
#pragma once
#include <optional>

#include "spectral_balance.hpp"

namespace diagnosis::runs {

struct HiddenMode {
  int dof = 0;  // from 0
  double resonance_Hz = 0, damping_ratio = 0, mass_kg = 0;
  Vec numbers;      // the rig's own beside it, as SpectralBalance has them
  double left = 1;  // of the squared balance that the rig alone leaves
};
// The mode on a DOF that leaves the least, of positive mass beside positive masses and springs.
std::optional<HiddenMode> hidden_mode(const SpectralBalance& balance, const Model& model);

// The model with the numbers that balance the forces best, no mode beside them. None where nothing drives the rig, or one of them is
// not possible.
std::optional<Model> balanced_numbers(const System& system, const std::vector<Prepared>& records, const Model& model);

}  // namespace diagnosis::runs
