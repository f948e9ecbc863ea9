// The rig of the comparison: the paper's chain at any length, ground - 1 - 2 - ... - n - ground, a viscous damper unknown in
// every link and Coulomb friction in the last; force on DOF 1; displacement, velocity and acceleration of every DOF measured.
#pragma once
#include <vector>

#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/configuration/configuration.hpp"

namespace bench {

constexpr double kMass_kg = 1.5, kStiffness_N_m = 1e4, kPeriod_s = 1e-3;

// all_unknown: not the dampers and the last link's friction alone, but every friction, and springs up to the core's capacity.
firmware::CoreConfiguration chain(int dofs, bool all_unknown = false);

// One sample in SI units; links 0 .. dofs, link l between DOF l - 1 and l (-1 and dofs are ground).
struct Sample {
  std::vector<double> x, v, a, f;
};

// The same motion as codes and as numbers: sums of sines of different phase, 64 samples long: they stay in the cache, as a sample fresh from a converter is.
std::vector<firmware::RawSample> raw_samples(int dofs);
std::vector<Sample> samples(int dofs);

}  // namespace bench
