// A spring that hardens, measured by a displacement whose zero is off by a quarter of the motion: what is missed all the time moves no
// phase, and no shorter window would mend it.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using two_masses::said;

constexpr double kMass_kg = 2, kStiffness_N_m = 3000, kViscous_N_s_m = 8, kRate_Hz = 500, kSeconds = 20;

struct Oscillator {
  double hardening_N_m3 = 0;
  std::vector<double> phase;

  // Forty tones from 1 to 12 Hz about the resonance at 6.2 Hz, 2.5 N each.
  double force_N(double t_s) const {
    double sum = 0;
    for (size_t i = 0; i < phase.size(); ++i)
      sum += 2.5 * std::cos(6.283185307 * (1 + 0.282 * static_cast<double>(i)) * t_s + phase[i]);
    return sum;
  }
  double acceleration(double t_s, double x, double v) const {
    return (force_N(t_s) - kStiffness_N_m * x - hardening_N_m3 * x * x * x - kViscous_N_s_m * v) / kMass_kg;
  }
  void step(double t_s, double h, double& x, double& v) const {  // Runge and Kutta's fourth order
    const double a1 = acceleration(t_s, x, v), v2 = v + h / 2 * a1;
    const double a2 = acceleration(t_s + h / 2, x + h / 2 * v, v2), v3 = v + h / 2 * a2;
    const double a3 = acceleration(t_s + h / 2, x + h / 2 * v2, v3), v4 = v + h * a3;
    const double a4 = acceleration(t_s + h, x + h * v3, v4);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4), v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
};

host_sim::Record record_of(double hardening_N_m3, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> turn(0, 6.283185307);
  std::normal_distribution<double> normal;
  Oscillator o;
  o.hardening_N_m3 = hardening_N_m3;
  for (int i = 0; i < 40; ++i) o.phase.push_back(turn(random));
  std::vector<double> f, x;
  double now = 0, rate = 0, square = 0;
  for (int i = 0; i < kSeconds * kRate_Hz; ++i) {
    f.push_back(o.force_N(i / kRate_Hz)), x.push_back(now), square += now * now;
    for (int k = 0; k < 4; ++k) o.step((i + k / 4.0) / kRate_Hz, 0.25 / kRate_Hz, now, rate);
  }
  const double rms = std::sqrt(square / static_cast<double>(x.size()));
  for (double& value : x) value += 0.25 * rms + 0.002 * rms * normal(random);
  host_sim::Record r;
  r.file = "oscillator.csv", r.sample_period_s = 1 / kRate_Hz;
  r.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, f},
                {"displacement_1_m", host_sim::Quantity::kDisplacement, 1, x}};
  return r;
}

std::string answer_to(double hardening_N_m3, unsigned seed) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.estimate = true;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m.estimate = rig.links[0].viscous_N_s_m.estimate = true;
  return said(diagnosis::diagnose(rig, {record_of(hardening_N_m3, seed)}, {}));
}

// 2e6 N/m^3 at 10 mm is 2 N beside the spring's 30 N.
TEST(ZeroOfDisplacement, HidesNoHardeningSpring) {
  for (unsigned seed : {11u, 12u, 13u}) {
    const std::string with = answer_to(2e6, seed), without = answer_to(0, seed);
    EXPECT_NE(with.find("cubic_stiffness on link 1-0"), std::string::npos) << seed << ": " << with;
    EXPECT_NE(with.find("force_offset on link 1-0"), std::string::npos) << seed << ": " << with;
    EXPECT_NE(without.find("force_offset on link 1-0"), std::string::npos) << seed << ": " << without;
    EXPECT_EQ(without.find("cubic"), std::string::npos) << seed << ": " << without;
  }
}

}  // namespace
