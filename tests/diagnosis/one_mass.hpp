// One mass of 3 kg on a spring of 7580 N/m with a damper of 10 N s/m and friction of the test's choice, which turns over within 1 mm/s;
// displacement and force alone. The plant is the tests' own: fourth order Runge-Kutta.
#pragma once
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace one_mass {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kMass_kg = 3, kStiffness_N_m = 7580, kViscous_N_s_m = 10;

struct Recording {
  double each_tone_N = 2.5;  // of forty, 2 to 15.65 Hz
  int samples = 10000;       // every 2 ms
  double noise_m = 2e-5;
};

// friction_N(rate): against the motion.
template <typename Friction>
host_sim::Record record(const Friction& friction_N, uint64_t seed, const Recording& recording = {}) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, kTwoPi);
  std::vector<double> omega, start;
  for (int i = 0; i < 40; ++i) omega.push_back(kTwoPi * (2 + 0.35 * i)), start.push_back(phase(random));
  const auto drive_N = [&](double t) {
    double sum = 0;
    for (size_t i = 0; i < omega.size(); ++i) sum += std::sin(omega[i] * t + start[i]);
    return recording.each_tone_N * sum;
  };
  const auto acceleration = [&](double t, double x, double v) {
    return (drive_N(t) - kStiffness_N_m * x - kViscous_N_s_m * v - friction_N(v) * std::tanh(v / 1e-3)) / kMass_kg;
  };
  host_sim::Record made;
  made.file = "rig.csv", made.sample_period_s = 2e-3;
  std::vector<double> force, place;
  const double h = 2e-4;
  double x = 0, v = 0;
  for (int k = 0; k < 10 * recording.samples; ++k) {
    const double t = k * h;
    if (k % 10 == 0)
      force.push_back(drive_N(t) + 0.05 * normal(random)), place.push_back(x + recording.noise_m * normal(random));
    const double a1 = acceleration(t, x, v), a2 = acceleration(t + h / 2, x + h / 2 * v, v + h / 2 * a1),
                 a3 = acceleration(t + h / 2, x + h / 2 * (v + h / 2 * a1), v + h / 2 * a2),
                 a4 = acceleration(t + h, x + h * (v + h / 2 * a2), v + h * a3);
    x += h * v + h * h / 6 * (a1 + a2 + a3), v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  made.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, force},
                   {"displacement_1_m", host_sim::Quantity::kDisplacement, 1, place}};
  return made;
}

// White noise of a share of the rms.
template <typename Random>
void add_noise(double share, Random& random, std::normal_distribution<double>& normal, std::vector<double>& y) {
  double square = 0;
  for (double value : y) square += value * value;
  for (double& value : y) value += share * std::sqrt(square / static_cast<double>(y.size())) * normal(random);
}

// Its rig file, or that of another mass on another spring; the damper unknown and no friction.
inline rig_file::RigModel rig(double mass_kg = kMass_kg, double stiffness_N_m = kStiffness_N_m) {
  rig_file::RigModel made;
  made.dofs.resize(1), made.links.resize(1);
  made.dofs[0].mass_kg.value = mass_kg;
  made.links[0].a = 1, made.links[0].b = rig_file::kGround;
  made.links[0].stiffness_N_m.value = stiffness_N_m, made.links[0].viscous_N_s_m.estimate = true;
  return made;
}

}  // namespace one_mass
