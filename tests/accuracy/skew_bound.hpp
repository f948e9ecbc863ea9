// How well white noise lets anyone measure the time skew between a displacement and a velocity.
#pragma once
#include <vector>

#include "host_sim/records/record.hpp"

namespace accuracy {

// Cramer-Rao bound of the standard deviation, in seconds, from noise-free records of one DOF with noise of
// `noise_percent` of rms on both: at each frequency the phase of X scatters by sigma_x / |X|, that of V by sigma_v / |V|,
// and a delay tau turns it by omega tau:  1 / var(tau) = sum over levels and frequencies of
// |V|^2 / (sigma_x^2 + sigma_v^2 / omega^2), |V|^2 scaled to the sum of v^2 over the samples.
double skew_bound_s(const std::vector<host_sim::Record>& clean, int dof, double noise_percent);

}  // namespace accuracy
