// Free runs with sensitivities: against motions worked out by hand and against differences.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/diagnosis/fit/fit.hpp"

namespace {

using namespace diagnosis;
using namespace diagnosis::runs;

constexpr double kPi = 3.141592653589793;

// One mass of 1 kg, a spring of 4 pi^2 N/m (1 Hz) and what the test adds; 100 Hz.
struct Rig {
  System system;
  Model model;
  std::vector<Prepared> records;
  explicit Rig(Index samples) {
    rig_file::RigModel rig;
    rig.dofs.resize(1), rig.links.resize(1);
    rig.links[0].a = 1, rig.links[0].b = 0;
    system = make_system(rig);
    add(on_dof(Kind::kMass, 0), 1, true), add(on_link(Kind::kStiffness, 0), 4 * kPi * kPi, true);
    Prepared p;
    p.step_s = 0.01, p.samples = samples, p.period_s = 1, p.top_Hz = 2;
    p.force = {Vec()}, p.guess.resize(2);
    p.guess[0] = {true, Vec::Zero(samples), Vec::Zero(samples), Vec::Zero(samples)};
    p.traces.push_back({0, 0, "displacement_1_m", Vec::Zero(samples)});
    records.push_back(p);
  }
  void add(const Term& term, double value, bool known) {
    ModelTerm t;
    t.term = term, t.value = value, t.known = known;
    model.push_back(t);
  }
  Vec run(double x, double v, Index samples) {
    Simulator s(system, model, records[0]);
    Vec y(2);
    y << x, v;
    s.start(0, y);
    for (Index k = 0; k + 1 < samples; ++k) s.advance(k, y, nullptr);
    return y;
  }
};

// Coulomb friction takes 4 F / k off the amplitude in every period and leaves the frequency: from 1 m after 1 s
// 1 - 4 * 1 / 39.478 = 0.89868 m, at rest.
TEST(FreeRun, CoulombFrictionTakesTheSameOffEveryPeriod) {
  Rig rig(201);
  rig.add(on_link(Kind::kCoulomb, 0), 1, true);
  EXPECT_NEAR(rig.run(1, 0, 101)[0], 1 - 4 / (4 * kPi * kPi), 1e-5);
}

// A spring of 4 pi^2 (u + 100 u^3) N is 301 times as steep at u = 1, twice an rms of 0.5, as at u = 0. Undamped,
// k u^2 / 2 + 100 k u^4 / 4 + v^2 / 2 = k (0.5 + 25) stays over a hundred swings (without the linear part one takes
// 7.4163 / (10 * 2 pi) s, 0.118 s); with steps that are short enough for the linear spring alone 72 % of it are lost.
TEST(FreeRun, StepsAreShortWhereASpringHardens) {
  Rig rig(1201);
  rig.add(on_link(Kind::kCubicStiffness, 0), 400 * kPi * kPi, true);
  for (Index k = 0; k < 1201; ++k) rig.records[0].guess[0].x[k] = k % 2 ? 0.5 : -0.5;
  const Vec y = rig.run(1, 0, 1201);
  const double k = 4 * kPi * kPi, energy = k * (0.5 * std::pow(y[0], 2) + 25 * std::pow(y[0], 4)) + y[1] * y[1] / 2;
  EXPECT_NEAR(energy / (k * 25.5), 1, 0.01);
}

// exp(slope * time_s) by its series over a 1024th of the time, squared ten times.
Mat exponential(const Mat& slope, double time_s) {
  const Mat part = slope * (time_s / 1024);
  Mat sum = Mat::Identity(slope.rows(), slope.cols()), term = sum;
  for (int n = 1; n <= 20; ++n) term = term * part / n, sum += term;
  for (int n = 0; n < 10; ++n) sum = sum * sum;
  return sum;
}

// Two masses of 1 kg in a row on springs of 300 N/m and dampers of 0.0214 N s/m. The fast mode, x2 = -0.618 x1, turns by 28.02 rad/s
// with a damping ratio of 0.0214 / 300 * 28.02 / 2 = 0.0010: 0.28 rad in 10 ms, where one step of order 4 damps by 0.28^5 / 144, 1.2 % of
// that. Over 20 s its energy falls to exp(-2 * 0.0010 * 28.02 * 20), to a thousandth of the exponent.
TEST(FreeRun, StepsDoNotDampALightlyDampedMode) {
  constexpr double kStiffness = 300, kViscous = 0.0214;
  Rig rig(2001);
  rig_file::RigModel two;
  two.dofs.resize(2), two.links.resize(2);
  two.links[0].a = 1, two.links[0].b = 0, two.links[1].a = 2, two.links[1].b = 1;
  rig.system = make_system(two), rig.model.clear();
  for (int i = 0; i < 2; ++i) {
    rig.add(on_dof(Kind::kMass, i), 1, true), rig.add(on_link(Kind::kStiffness, i), kStiffness, true);
    rig.add(on_link(Kind::kViscous, i), kViscous, true);
  }
  Prepared& p = rig.records[0];
  p.force = {Vec(), Vec()}, p.guess.insert(p.guess.begin(), p.guess[0]);
  Mat pull(2, 2), slope = Mat::Zero(4, 4);
  pull << 2, -1, -1, 1;
  slope.topRightCorner(2, 2) = Mat::Identity(2, 2);
  slope.bottomLeftCorner(2, 2) = -kStiffness * pull, slope.bottomRightCorner(2, 2) = -kViscous * pull;
  const auto energy = [&](const Vec& y) {
    return y.tail(2).squaredNorm() / 2 + kStiffness / 2 * y.head(2).dot(pull * y.head(2));
  };
  Vec start(4), y;
  start << 1, -0.618034, 0, 0;
  Simulator simulator(rig.system, rig.model, p);
  simulator.start(0, y = start);
  for (Index k = 0; k < 2000; ++k) simulator.advance(k, y, nullptr);
  const double exact = std::log(energy(start) / energy(exponential(slope, 20) * start));
  EXPECT_NEAR(exact, 2 * 0.0214 / 300 * 28.02 / 2 * 28.02 * 20, 1e-3);
  EXPECT_NEAR(std::log(energy(start) / energy(y)), exact, 1e-3 * exact);
}

// At 0.02 m the spring pulls with 0.79 N, less than the friction of 1 N: it stays.
TEST(FreeRun, FrictionHoldsWhatTheSpringCannotMove) {
  Rig rig(201);
  rig.add(on_link(Kind::kCoulomb, 0), 1, true);
  const Vec y = rig.run(0.02, 0, 201);
  EXPECT_NEAR(y[0], 0.02, 1e-4);
  EXPECT_NEAR(y[1], 0, 1e-9);
}

// Sensitivities of a run that turns six times, to its first state and to viscous and Coulomb friction, against
// differences.
TEST(FreeRun, SensitivitiesAreThoseOfDifferences) {
  Rig rig(301);
  rig.add(on_link(Kind::kViscous, 0), 0.3, false), rig.add(on_link(Kind::kCoulomb, 0), 1, false);
  Simulator s(rig.system, rig.model, rig.records[0]);
  Vec y(2);
  y << 1, 0.5;
  Sensitivity total = Sensitivity::Zero(2, 4);
  total.leftCols(2).setIdentity();
  s.start(0, y);
  for (Index k = 0; k < 290; ++k) s.advance(k, y, &total);
  const double step = 1e-5;
  for (int column = 0; column < 4; ++column) {
    Vec ends[2];
    for (int side = 0; side < 2; ++side) {
      const double d = side == 0 ? -step : step;
      Rig other = rig;
      if (column >= 2) other.model[static_cast<size_t>(column)].value += d;
      ends[side] = other.run(1 + (column == 0 ? d : 0), 0.5 + (column == 1 ? d : 0), 291);
    }
    const Vec slope = (ends[1] - ends[0]) / (2 * step);
    EXPECT_NEAR(total(0, column), slope[0], 2e-3 * (1 + std::abs(slope[0]))) << "column " << column;
    EXPECT_NEAR(total(1, column), slope[1], 2e-3 * (1 + std::abs(slope[1]))) << "column " << column;
  }
}

// A step that begins with the accelerations asked for before it ends where it would have ended; those of another state, or asked
// for without slopes, are none to begin with.
TEST(FreeRun, AskingForAccelerationsChangesNoStep) {
  Rig rig(101);
  rig.add(on_link(Kind::kViscous, 0), 0.3, false), rig.add(on_link(Kind::kCoulomb, 0), 1, false);
  const auto run = [&](int asked) {
    Simulator s(rig.system, rig.model, rig.records[0]);
    Vec y(2), acceleration;
    y << 1, 0.5;
    Sensitivity total = Sensitivity::Zero(2, 4);
    total.leftCols(2).setIdentity();
    s.start(0, y);
    for (Index k = 0; k < 100; ++k) {
      const Vec other = Vec::Constant(2, -3);
      Mat slopes;
      if (asked > 0) s.accelerations(k, asked == 2 ? other : y, acceleration, asked == 3 ? nullptr : &slopes);
      s.advance(k, y, &total);
    }
    Mat all(2, 5);
    all << y, total;
    return all;
  };
  const Mat plain = run(0);
  for (const int asked : {1, 2, 3}) EXPECT_EQ(run(asked), plain) << asked;
}

// x = exp(-d t) cos(w t) with c = 2 d m: 0.4 N s/m is found from its displacement to 1e-4, from a first value of 0.1.
TEST(FreeRun, FitFindsViscousDamping) {
  Rig rig(801);
  rig.add(on_link(Kind::kViscous, 0), 0.1, false);
  const double d = 0.2, w = std::sqrt(4 * kPi * kPi - d * d);
  Prepared& p = rig.records[0];
  for (Index k = 0; k < p.samples; ++k) {
    const double t = p.time_s(k), e = std::exp(-d * t);
    p.traces[0].y[k] = p.guess[0].x[k] = e * std::cos(w * t);
    p.guess[0].v[k] = e * (-d * std::cos(w * t) - w * std::sin(w * t));
  }
  std::vector<Window> windows(4);
  for (size_t i = 0; i < 4; ++i) windows[i].from = static_cast<Index>(200 * i), windows[i].length = 200;
  const Fitted found = fit(rig.system, rig.records, rig.model, windows, 10);
  ASSERT_TRUE(found.ok);
  EXPECT_NEAR(rig.model[2].value, 0.4, 1e-4);
}

// Beside given numbers too a channel counts for what is left of it. Two periods of cos(2 pi t) m, read to 1 mm; the velocity reads a
// tenth too much, and 0.628 m/s to either side in turn. An amplitude A leaves (1 - A)^2 / 2 + 1e-6 m^2 of the one and
// 4 pi^2 (1.1 - A)^2 / 2 + 0.394 m^2/s^2 of the other; the sum of their logarithms is least where
// A - 1 = 1e-6 * 4 pi^2 * 0.1 / 0.59 = 7e-6. In the weights of a first guess of nought it would be 1.045.
TEST(FreeRun, StatesBesideGivenNumbersWeighChannelsByWhatTheyLeave) {
  Rig rig(200);
  Prepared& p = rig.records[0];
  p.traces.push_back({0, 1, "velocity_1_m_s", Vec::Zero(200)});
  for (Index k = 0; k < 200; ++k) {
    const double turn = 2 * kPi * p.time_s(k), side = k % 2 ? 1 : -1;
    p.traces[0].y[k] = std::cos(turn) + 1e-3 * side;
    p.traces[1].y[k] = -1.1 * 2 * kPi * std::sin(turn) + 0.1 * 2 * kPi * side;
  }
  std::vector<Window> windows(1);
  windows[0].length = 200;
  ASSERT_TRUE(fit(rig.system, rig.records, rig.model, windows, 12, true).ok);
  EXPECT_NEAR(windows[0].state[0], 1, 1e-4);
}

// A damping of 1 - v^2 N s/m drives what is faster than 1 m/s: from 5 m/s, v' = -v + v^3 runs away within 0.02 s. A window whose
// state was fitted beside another law is started from the measured motion, and follows it.
TEST(FreeRun, AStateOutOfTheLawsReachIsForgotten) {
  Rig rig(101);
  rig.add(on_link(Kind::kViscous, 0), 1, true), rig.add(on_link(Kind::kCubicDamping, 0), -1, true);
  Prepared& p = rig.records[0];
  for (Index k = 0; k < 101; ++k) {
    const Vec y = rig.run(0.1, 0, k + 1);
    p.traces[0].y[k] = p.guess[0].x[k] = y[0], p.guess[0].v[k] = y[1];
  }
  Window w;
  w.length = 101;
  std::vector<Window> windows = {w};
  ASSERT_TRUE(fit(rig.system, rig.records, rig.model, windows, 6, true).ok);
  windows[0].state[1] = 5;
  const Fitted again = fit(rig.system, rig.records, rig.model, windows, 6, true);
  ASSERT_TRUE(again.ok);
  EXPECT_LT(std::sqrt(again.mean_square[0]), 1e-6);
  EXPECT_NEAR(windows[0].state[0], 0.1, 1e-4);
}

// A decay is linear in where it begins: one step finds that, and a second one, that it brings nothing. Slopes are made for steps alone.
TEST(FreeRun, SlopesAreMadeOnceAStep) {
  Rig rig(201);
  rig.add(on_link(Kind::kViscous, 0), 0.4, false);
  Prepared& p = rig.records[0];
  for (Index k = 0; k < p.samples; ++k) p.traces[0].y[k] = rig.run(1, 0, k + 1)[0] + (k % 2 ? 0.01 : -0.01);
  Window w;
  w.length = 201, w.state = Vec::Zero(2);
  std::vector<Window> windows = {w};
  EXPECT_EQ(approach(rig.system, rig.records, rig.model, windows, 10, true), 2);
  EXPECT_NEAR(windows[0].state[0], 1, 1e-3);
  EXPECT_EQ(approach(rig.system, rig.records, rig.model, windows, 10, true), 1);
  EXPECT_EQ(rig.model[2].value, 0.4);
  EXPECT_FALSE(rig.model[2].known);
}

}  // namespace
