// Energy of a simulated run: what the forces put in is stored or dissipated, to 1e-8 of what went through.
//
// The integrals are taken here from the samples, independently of the integrator: between two samples the motion is a
// quintic through displacement, velocity and acceleration; where a rate changes its sign or the acceleration jumps the
// interval is cut at the crossing. Links are sampled at 10 kHz so that these quintics are exact enough.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/plant/motion/simulate.hpp"
#include "tests/plant/rigs.hpp"

namespace {

using host_sim::Quantity;
using plant_test::oscillator;
constexpr double kTwoPi = 6.28318530717958647692;

// Five-point Gauss-Legendre over [0, 1].
constexpr double kNode[] = {0.046910077030668, 0.2307653449471585, 0.5, 0.7692346550528415, 0.953089922969332};
constexpr double kWeight[] = {0.1184634425280945, 0.2393143352496832, 0.2844444444444444, 0.2393143352496832,
                              0.1184634425280945};

struct Sample {
  double x, v, a;
};

// Velocity at the fraction s of an interval h between two samples (derivative of the quintic).
double velocity(const Sample& p, const Sample& q, double h, double s) {
  const double dx = q.x - p.x - p.v * h - 0.5 * p.a * h * h, dv = (q.v - p.v - p.a * h) * h, da = (q.a - p.a) * h * h;
  const double c3 = 10 * dx - 4 * dv + 0.5 * da, c4 = -15 * dx + 7 * dv - da, c5 = 6 * dx - 3 * dv + 0.5 * da;
  return p.v + s * p.a * h + (3 * c3 * s * s + 4 * c4 * s * s * s + 5 * c5 * s * s * s * s) / h;
}

// m = 2, k = 800, c = 4, F = 2 under 60 cos(2 pi 4 t) + settled start: no sticking, two sign changes a cycle.
TEST(Energy, InputIsStoredOrDissipated) {
  const double h = 1e-4, c = 4.0, coulomb = 2.0, force_N = 60.0, f_Hz = 4.0;
  host_sim::Excitation excitation;
  excitation.force_N = {host_sim::cosine(force_N, f_Hz)};
  const size_t count = 20001;
  const auto record =
      host_sim::simulate(oscillator(2.0, 800.0, c, coulomb), {{0.05}, {0.3}}, excitation, {h, 0, 0, count, 0.0});
  const auto& x = record.find(Quantity::kDisplacement, 1)->values;
  const auto& v = record.find(Quantity::kVelocity, 1)->values;
  const auto& a = record.find(Quantity::kAcceleration, 1)->values;
  double input = 0.0, viscous = 0.0, friction = 0.0;
  for (size_t i = 0; i + 1 < count; ++i) {
    Sample p{x[i], v[i], a[i]}, q{x[i + 1], v[i + 1], a[i + 1]};
    const double t = h * static_cast<double>(i);
    const bool crosses = p.v * q.v < 0.0;
    if (crosses) {
      // The acceleration jumps by 2 F / m where v = 0. Both sides are short (1e-4 s): constant acceleration on each,
      // off by jerk * (1e-4 s)^3 ~ 1e-9 m of way.
      const double tau = -p.v / p.a, rest = h - tau;
      friction += coulomb * (0.5 * std::fabs(p.v) * tau + 0.5 * std::fabs(q.v) * rest);
      viscous += c * (p.v * p.v * tau + q.v * q.v * rest) / 3.0;
      input += force_N *
               (std::cos(kTwoPi * f_Hz * t) * 0.5 * p.v * tau + std::cos(kTwoPi * f_Hz * (t + h)) * 0.5 * q.v * rest);
      continue;
    }
    for (int g = 0; g < 5; ++g) {
      const double w = velocity(p, q, h, kNode[g]);
      input += h * kWeight[g] * force_N * std::cos(kTwoPi * f_Hz * (t + kNode[g] * h)) * w;
      viscous += h * kWeight[g] * c * w * w;
      friction += h * kWeight[g] * coulomb * std::fabs(w);
    }
  }
  const auto stored = [&](size_t i) { return v[i] * v[i] + 400.0 * x[i] * x[i]; };
  const double through = viscous + friction;
  EXPECT_GT(through, 1.0);
  EXPECT_LT(std::fabs(input - viscous - friction - (stored(count - 1) - stored(0))), 1e-8 * through);
}

// Without crossings the sum must hold to 1e-8 with nothing forgiven: a smooth chain of two bodies, cubic spring,
// viscous links.
TEST(Energy, SmoothChainBalancesTo1e8) {
  rig_file::RigModel rig = oscillator(1.5, 1e4, 20.0);
  rig.dofs.push_back(rig.dofs[0]);
  rig_file::Link second = rig.links[0];
  second.a = 2;
  second.b = 1;
  second.effects.push_back(plant_test::effect("cubic_stiffness", 1e6));
  rig.links.push_back(second);
  host_sim::Excitation excitation;
  excitation.force_N = {nullptr, host_sim::cosine(50.0, 7.0)};
  const double h = 2e-4;
  const size_t count = 10001;
  const auto record = host_sim::simulate(rig, {{0.01, -0.01}, {0.0, 0.0}}, excitation, {h, 0, 0, count, 0.0});
  const auto sample = [&](int dof, size_t i) {
    return Sample{record.find(Quantity::kDisplacement, dof)->values[i],
                  record.find(Quantity::kVelocity, dof)->values[i],
                  record.find(Quantity::kAcceleration, dof)->values[i]};
  };
  double input = 0.0, viscous = 0.0;
  for (size_t i = 0; i + 1 < count; ++i)
    for (int g = 0; g < 5; ++g) {
      const double w1 = velocity(sample(1, i), sample(1, i + 1), h, kNode[g]);
      const double w2 = velocity(sample(2, i), sample(2, i + 1), h, kNode[g]);
      input += h * kWeight[g] * 50.0 * std::cos(kTwoPi * 7.0 * h * (static_cast<double>(i) + kNode[g])) * w2;
      viscous += h * kWeight[g] * 20.0 * (w1 * w1 + (w2 - w1) * (w2 - w1));
    }
  const auto stored = [&](size_t i) {
    const Sample p = sample(1, i), q = sample(2, i);
    const double u = q.x - p.x;
    return 0.75 * (p.v * p.v + q.v * q.v) + 5e3 * (p.x * p.x + u * u) + 0.25e6 * u * u * u * u;
  };
  EXPECT_NEAR(input - viscous, stored(count - 1) - stored(0), 1e-8 * viscous);
}

// Coulomb friction alone, where the answer is exact whatever the sampling: the energy lost between release and rest is
// F times the way. m = 1, k = 100, F = 1 from 0.095: way = 0.17 + 0.13 + 0.09 + 0.05 + 0.01 = 0.45 m (turning points as
// in response_test), energy 0.5 * 100 * (0.095^2 - 0.005^2) = 0.45 J.
TEST(Energy, CoulombFrictionTakesForceTimesWay) {
  const double half = kTwoPi / 20.0;
  const auto record =
      host_sim::simulate(oscillator(1.0, 100.0, 0.0, 1.0), {{0.095}, {0.0}}, {}, {half / 100, 0, 0, 801, 0.0});
  const auto& x = record.find(Quantity::kDisplacement, 1)->values;
  double way = 0.0;
  for (size_t i = 0; i + 1 < x.size(); ++i) way += std::fabs(x[i + 1] - x[i]);
  EXPECT_NEAR(way, 0.45, 0.45e-8);
  EXPECT_NEAR(50.0 * (0.095 * 0.095 - x.back() * x.back()), way, 0.45e-8);
}

}  // namespace
