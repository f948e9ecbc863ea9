// A mode inside the motion's band that the rig file lacks: accelerometer and force alone, mass and spring unknown, as a shaker test has
// them. The plant is the test's own: fourth order Runge-Kutta.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/diagnosis/choice/horizon.hpp"
#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/diagnosis/first_values/mode_scan.hpp"
#include "host_sim/diagnosis/first_values/start.hpp"
#include "host_sim/diagnosis/trial/bristles.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;

constexpr double kMass_kg = 13.5, kStiffness_N_m = 1.6e7, kViscous_N_s_m = 475;  // 173 Hz
constexpr double kSample_s = 1.0 / 3200;
constexpr int kSamples = 16000, kFine = 4;

struct Mode {
  double mass_kg, hertz;  // damped by 2 %
};

// Force: a hundred tones from 40 to 400 Hz of random phases; unmeasured_N: of each of as many between them, that no channel tells of.
host_sim::Record shaken(const Mode& mode, uint64_t seed, double unmeasured_N = 0) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, kTwoPi);
  std::vector<double> omega, start;
  for (int i = 0; i < 200; ++i) omega.push_back(kTwoPi * (40 + 1.8 * i)), start.push_back(phase(random));
  const auto tones = [&](double t, size_t from) {
    double sum = 0;
    for (size_t i = from; i < omega.size(); i += 2) sum += std::sin(omega[i] * t + start[i]);
    return sum;
  };
  const auto force_N = [&](double t) { return tones(t, 0) + (unmeasured_N > 0 ? unmeasured_N * tones(t, 1) : 0.0); };
  const double own = kTwoPi * mode.hertz, k = mode.mass_kg * own * own, c = 0.04 * own * mode.mass_kg;
  struct Motion {
    double x, v, z, s;
  };
  const auto slope = [&](double f, const Motion& y) {
    const double pull = k * (y.x - y.z) + c * (y.v - y.s);
    return Motion{y.v, (f - kStiffness_N_m * y.x - kViscous_N_s_m * y.v - pull) / kMass_kg, y.s,
                  mode.mass_kg > 0 ? pull / mode.mass_kg : 0};
  };
  const auto along = [](const Motion& y, const Motion& d, double h) {
    return Motion{y.x + h * d.x, y.v + h * d.v, y.z + h * d.z, y.s + h * d.s};
  };
  std::vector<double> force, acceleration;
  Motion y{0, 0, 0, 0};
  const double h = kSample_s / kFine;
  double now = force_N(0);
  for (int i = 0; i < kFine * kSamples; ++i) {
    const double middle = force_N((i + 0.5) * h), next = force_N((i + 1) * h);
    const Motion a = slope(now, y);
    if (i % kFine == 0) force.push_back(tones(i * h, 0)), acceleration.push_back(a.v + 0.005 * normal(random));
    const Motion b = slope(middle, along(y, a, h / 2)), d = slope(middle, along(y, b, h / 2)),
                 e = slope(next, along(y, d, h));
    y = {y.x + h / 6 * (a.x + 2 * b.x + 2 * d.x + e.x), y.v + h / 6 * (a.v + 2 * b.v + 2 * d.v + e.v),
         y.z + h / 6 * (a.z + 2 * b.z + 2 * d.z + e.z), y.s + h / 6 * (a.s + 2 * b.s + 2 * d.s + e.s)};
    now = next;
  }
  host_sim::Record made;
  made.file = "shaken.csv", made.sample_period_s = kSample_s;
  made.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, force},
                   {"acceleration_1_m_s2", host_sim::Quantity::kAcceleration, 1, acceleration}};
  return made;
}

rig_file::RigModel rig() {
  rig_file::RigModel made;
  made.dofs.resize(1), made.links.resize(1);
  made.dofs[0].mass_kg.estimate = true;
  made.links[0].a = 1;
  made.links[0].stiffness_N_m.estimate = true, made.links[0].viscous_N_s_m.estimate = true;
  return made;
}

// Own numbers fitted without the mode are 7 % (mass) and 26 % (spring) off and leave 7 % of the motion.
TEST(HiddenMode, InTheMotionsBandIsNamedWithTheRigsOwnNumbers) {
  for (const Mode& mode : {Mode{4, 110}, Mode{2, 180}}) {
    const Diagnosis d = diagnose(rig(), {shaken(mode, 7)}, {});
    EXPECT_EQ(two_masses::said(d), "explained, unmodelled_resonance on dof 1") << mode.hertz;
    const double truth[] = {kMass_kg, kStiffness_N_m, kViscous_N_s_m, mode.mass_kg, mode.hertz};
    const char* names[] = {"mass[1]", "stiffness[1-0]", "viscous[1-0]", "unmodelled_resonance[1]",
                           "resonance_frequency[1]"};
    for (int i = 0; i < 5; ++i)
      EXPECT_NEAR(two_masses::value_of(d.extended, names[i]), truth[i], 0.01 * truth[i]) << names[i];
  }
}

TEST(HiddenMode, IsNotNamedWhereThereIsNone) {
  const Diagnosis d = diagnose(rig(), {shaken({0, 110}, 7)}, {});
  EXPECT_EQ(two_masses::said(d), "none");
}

// A force that no channel tells of makes two fifths of the motion: no window is followed to a quarter. Windows of a quarter of a period
// follow anything from their own states: from first values that are far off, their numbers stay so.
TEST(NothingIsFollowed, TheNumbersAreThoseOfWholePeriods) {
  const rig_file::RigModel model = rig();
  const System system = make_system(model);
  const std::vector<runs::Prepared> records = runs::prepare_all(model, {shaken({0, 110}, 7, 0.45)}, {});
  const runs::Task task{system, records, 1};
  runs::State s;
  s.model = runs::rig_as_given(system, records);
  const double first[] = {0.3, 6e6, 480};
  for (size_t i = 0; i < s.model.size(); ++i) s.model[i].value = first[i];
  EXPECT_GE(runs::horizon(task, s, runs::longest_horizon(records), false), runs::kLeastPeriods);
  EXPECT_NEAR(s.model[0].value, kMass_kg, 0.3 * kMass_kg);
  EXPECT_NEAR(s.model[1].value, kStiffness_N_m, 0.3 * kStiffness_N_m);
}

// The balance by hand: a force of 1 N on 2 kg, 8000 N/m, 20 N s/m and a mode of 0.5 kg at 12 Hz, damped by 2 %.
TEST(HiddenMode, StandsInTheBalanceOfForces) {
  runs::Model model(3);
  model[0].term = on_dof(Kind::kMass, 0), model[1].term = on_link(Kind::kStiffness, 0),
  model[2].term = on_link(Kind::kViscous, 0);
  runs::SpectralBalance b;
  const int rows = 60;
  b.numbers = {0, 1, 2}, b.hertz.resize(rows), b.columns.resize(rows, 3), b.given.resize(rows);
  b.mode_acceleration.resize(rows);
  for (int i = 0; i < rows; ++i) {
    const double hertz = 4 + 0.3 * i, omega = kTwoPi * hertz, r = hertz / 12;
    const Complex damped(0, 0.04 * r), of_mode = (1.0 + damped) / (1.0 - r * r + damped);
    const Complex a = 1.0 / (2.0 - 8000 / (omega * omega) + 20.0 / Complex(0, omega) + 0.5 * of_mode);
    b.dof.push_back(0), b.hertz[i] = hertz, b.given[i] = 1, b.mode_acceleration[i] = a;
    b.columns(i, 0) = a, b.columns(i, 1) = -a / (omega * omega), b.columns(i, 2) = a / Complex(0, omega);
  }
  const auto mode = runs::hidden_mode(b, model);
  ASSERT_TRUE(mode);
  EXPECT_NEAR(mode->resonance_Hz, 12, 0.2);  // on a grid of 3 %
  EXPECT_NEAR(mode->mass_kg, 0.5, 0.05);
  EXPECT_NEAR(mode->numbers[0], 2, 0.05);
  EXPECT_NEAR(mode->numbers[1], 8000, 200);
  EXPECT_LT(mode->left, 0.1);
}

}  // namespace
