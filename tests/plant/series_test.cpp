// Steps by the Taylor series: solutions worked out by hand to the rounding of a double, and SUNDIALS at its tightest beside it.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/plant/motion/simulate.hpp"
#include "tests/plant/rigs.hpp"

namespace {

using host_sim::Method;
using host_sim::Quantity;
using plant_test::oscillator;
constexpr double kPi = 3.14159265358979323846;

host_sim::Record run(const rig_file::RigModel& rig, const host_sim::InitialState& initial, size_t count,
                     double period_s, const host_sim::Excitation& excitation = {}, Method method = Method::kSeries,
                     double tolerance = 1e-10) {
  return host_sim::simulate(rig, initial, excitation, {period_s, 0, 0, count}, {method, tolerance, 200000});
}

// Chain of two bodies: ground - 1 - 2 - end, friction in the first and the last link.
rig_file::RigModel chain(double friction_1_N, double friction_2_N, int end) {
  rig_file::RigModel rig = oscillator(1.5, 9000.0, 15.0, friction_1_N);
  rig.dofs.push_back(rig.dofs[0]);
  rig.dofs[1].mass_kg.value = 0.8;
  const int ends[2][2] = {{1, 2}, {2, end}};
  for (const auto& [a, b] : ends) {
    rig_file::Link link = rig.links[0];
    link.a = a, link.b = b;
    link.coulomb_N.value = b == end ? friction_2_N : 0.0;
    rig.links.push_back(link);
  }
  return rig;
}

double worst_difference(const host_sim::Record& a, const host_sim::Record& b, Quantity quantity, int dof) {
  double worst = 0.0, peak = 0.0;
  for (size_t i = 0; i < a.samples(); ++i) {
    const double value = b.find(quantity, dof)->values[i];
    worst = std::max(worst, std::fabs(a.find(quantity, dof)->values[i] - value));
    peak = std::max(peak, std::fabs(value));
  }
  return worst / peak;
}

// m = 1, k = 400, c = 2: x = e^-t (cos wd t + sin(wd t) / wd), wd = sqrt(399), for x0 = 1, v0 = 0. 3000 steps of some ten
// roundings each of 1.1e-16.
TEST(TaylorStep, DecayIsExact) {
  const auto record = run(oscillator(1.0, 400.0, 2.0), {{1.0}, {0.0}}, 3001, 1e-3);
  const double wd = std::sqrt(399.0);
  for (size_t i = 0; i < 3001; i += 50) {
    const double t = 1e-3 * static_cast<double>(i);
    EXPECT_NEAR(record.find(Quantity::kDisplacement, 1)->values[i],
                std::exp(-t) * (std::cos(wd * t) + std::sin(wd * t) / wd), 1e-12);
  }
}

// m = 1, k = 4e6 (2000 rad/s), samples 10 ms apart: 20 rad a sample are many steps, with the same cosine.
TEST(TaylorStep, StiffRigTakesShorterSteps) {
  const auto record = run(oscillator(1.0, 4e6), {{1.0}, {0.0}}, 101, 1e-2);
  for (size_t i = 0; i < 101; ++i)
    EXPECT_NEAR(record.find(Quantity::kDisplacement, 1)->values[i], std::cos(20.0 * static_cast<double>(i)), 1e-10);
}

// m = 2, k = 0, force 3 + t + 2 t^2 at knots: x'' = f / 2, so v = (3 t + t^2 / 2 + 2 t^3 / 3) / 2.
TEST(TaylorStep, PolynomialForceIsIntegratedExactly) {
  std::vector<double> force;
  for (int i = 0; i <= 50; ++i) force.push_back(3.0 + 0.01 * i + 2e-4 * i * i);
  host_sim::Excitation excitation;
  excitation.force_N = {host_sim::sampled(force, 0.0, 0.01)};
  const auto record = run(oscillator(2.0, 0.0), {{0.0}, {0.0}}, 51, 0.01, excitation);
  for (size_t i = 0; i < 51; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    EXPECT_NEAR(record.find(Quantity::kVelocity, 1)->values[i], (3.0 * t + t * t / 2.0 + 2.0 * t * t * t / 3.0) / 2.0,
                1e-13);
  }
}

// m = 1, k = 100 (w = 10), F = 1, force 3 cos 5 t, x0 = 0.05: x = 0.01 + 0.04 cos 5 t, 3 / (100 - 25) = 0.04, until v = -0.2 sin 5 t
// is zero at pi / 5. There k x = -3 and f = -3 leave nothing: held at -0.03 until 3 + 3 cos 5 t = 1, cos 5 t = -2/3 and sin 5 t =
// -sqrt(5) / 3. Then x = -0.01 + 0.04 cos 5 t + a cos 10 s + b sin 10 s, s from there: a = 0.02 / 3, b = -0.02 sqrt(5) / 3.
TEST(TaylorStep, FrictionHoldsAndLetsGoInTime) {
  host_sim::Excitation excitation;
  excitation.force_N = {host_sim::cosine(3.0, 5.0 / (2.0 * kPi))};
  const auto record = run(oscillator(1.0, 100.0, 0.0, 1.0), {{0.05}, {0.0}}, 180, kPi / 500.0, excitation);
  const double turn = kPi / 5.0, go = turn + std::acos(2.0 / 3.0) / 5.0;
  for (size_t i = 0; i < 180; ++i) {
    const double t = kPi / 500.0 * static_cast<double>(i), s = t - go;
    const double x = t <= turn  ? 0.01 + 0.04 * std::cos(5.0 * t)
                     : s <= 0.0 ? -0.03
                                : -0.01 + 0.04 * std::cos(5.0 * t) +
                                      0.02 / 3.0 * (std::cos(10.0 * s) - std::sqrt(5.0) * std::sin(10.0 * s));
    EXPECT_NEAR(record.find(Quantity::kDisplacement, 1)->values[i], x, 1e-11) << i;  // the hold's margin is 1e-10 of it
  }
}

// A rate that leaves its sign and is back within one sample (10 samples a cycle): as with 100 samples a cycle.
TEST(TaylorStep, ShortReversalIsSeen) {
  host_sim::Excitation excitation;
  excitation.force_N = {host_sim::cosine(40.0, 3.0), host_sim::cosine(25.0, 11.0, 0.7)};
  const rig_file::RigModel rig = chain(2.0, 1.0, 0);
  const auto coarse = run(rig, {}, 200, 0.02, excitation), fine = run(rig, {}, 19901, 0.0002, excitation);
  for (size_t i = 0; i < 200; ++i)
    EXPECT_NEAR(coarse.find(Quantity::kDisplacement, 2)->values[i],
                fine.find(Quantity::kDisplacement, 2)->values[100 * i], 1e-10)
        << i;
}

// ARKODE comes nearer to the series by 2 for every 10 of its tolerance: what is left is its own.
TEST(TaylorStep, FrictionThatHoldsAgreesWithArkode) {
  host_sim::Excitation excitation;
  excitation.force_N = {host_sim::random_band({6.0, 5.0, 50.0}, 0.0, 4.0, 1e-3, 7, 0)};
  for (const double friction_N : {0.5, 4.0}) {  // slides nearly always; is held half of the time
    const rig_file::RigModel rig = chain(friction_N, 0.5 * friction_N, 0);
    const auto series = run(rig, {}, 4000, 1e-3, excitation),
               arkode = run(rig, {}, 4000, 1e-3, excitation, Method::kFehlberg8, 1e-11);
    for (int dof : {1, 2})
      for (const Quantity quantity : {Quantity::kDisplacement, Quantity::kVelocity})
        EXPECT_LT(worst_difference(series, arkode, quantity, dof), 5e-8) << friction_N << " " << dof;
  }
}

TEST(TaylorStep, MovingBaseAgreesWithArkode) {
  host_sim::Excitation excitation;
  excitation.base_m = host_sim::cosine(0.002, 9.0);
  const rig_file::RigModel rig = chain(0.3, 3.0, rig_file::kBase);  // the base carries mass 2 with it at times
  const auto series = run(rig, {}, 3000, 1e-3, excitation),
             arkode = run(rig, {}, 3000, 1e-3, excitation, Method::kFehlberg8, 1e-11);
  for (int dof : {1, 2}) EXPECT_LT(worst_difference(series, arkode, Quantity::kVelocity, dof), 1e-8) << dof;
}

// The series of every kind of signal says what the signal says, over the stretch that it holds for.
TEST(Signal, SeriesIsTheSignal) {
  const std::vector<double> values = {0.3, -1.0, 2.0, 0.5, 0.1, -0.7, 1.5, 0.2, 0.9, -0.4};
  const host_sim::SignalPtr signals[] = {host_sim::cosine(2.0, 3.0, 0.4), host_sim::sampled(values, 0.1, 0.05),
                                         host_sim::sampled(values, 0.1, 0.05, host_sim::Interpolation::kLinear)};
  for (const auto& signal : signals)
    for (const double t : {0.0, 0.1, 0.17, 0.25 + 1e-14, 0.4, 0.54, 0.56}) {
      const double step = std::min(0.05, signal->smooth_until(t) - t);
      ASSERT_GT(step, 0.0);
      double c[24];
      const int count = signal->expand(t, step, 24, c);
      for (const double theta : {0.0, 0.3, 0.9}) {
        double value = 0.0;
        for (int k = count - 1; k >= 0; --k) value = value * theta + c[k];
        EXPECT_NEAR(value, signal->value(t + theta * step), 1e-10) << t;
      }
    }
}

}  // namespace
