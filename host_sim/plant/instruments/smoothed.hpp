// Samples without the white noise on them.
#pragma once
#include <vector>

namespace host_sim {

// The series of least sum of (values - series)^2 + stiffness * (third difference)^2 (Whittaker), its stiffness by generalised
// cross-validation (Craven and Wahba). The values themselves where no stiffness serves: of clean samples.
std::vector<double> smoothed(const std::vector<double>& values);

}  // namespace host_sim
