// Natural frequencies, damping ratios and mode shapes of a rig's linear part, with the intervals that its estimated
// coefficients give them.
#pragma once
#include <complex>
#include <vector>

#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/rig_model.hpp"

namespace host_sim {

// An eigenvalue pair lambda, conj(lambda) of d/dt [x; v] = A [x; v]. Natural frequency |lambda| / 2 pi, damping ratio
// -Re lambda / |lambda|.
struct Mode {
  double frequency_Hz = 0.0, damping_ratio = 0.0;
  std::vector<std::complex<double>> shape;  // displacement per DOF, the largest 1
};

// Oscillating modes, lowest frequency first; what creeps or moves as a rigid body has none. Empty where a DOF has no
// mass. rig: every coefficient a number.
std::vector<Mode> modes_of(const rig_file::RigModel& rig);

// No mode of the undamped rig is slower, Hz: the root of the least eigenvalue of M^-1/2 K M^-1/2, where springs that are estimated
// count as none. 0 where a mass is estimated or nought, and where something moves against no spring.
double slowest_mode_Hz(const rig_file::RigModel& model);

struct Uncertain {
  double value, low, high;  // 95 % interval; not numbers where it is not known
};
struct UncertainMode {
  Uncertain frequency_Hz, damping_ratio;
  std::vector<std::complex<double>> shape;
};

// model: the rig with its unknowns; values and covariance of the unknowns in the order of rig_file::parameter_table.
// The interval is linear in the coefficients (central differences): 1.96 standard deviations to either side. It is not known where a
// coefficient that has no variance moves the mode, nor where the mode comes or goes within a tenth of a standard deviation of one.
std::vector<UncertainMode> modes_with_intervals(const rig_file::RigModel& model, const std::vector<double>& values,
                                                const std::vector<std::vector<double>>& covariance);

}  // namespace host_sim
