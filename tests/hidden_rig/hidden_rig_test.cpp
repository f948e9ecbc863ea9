// The generator against solutions worked out by hand, and every condition against what its name says.
#include <gtest/gtest.h>

#include <cmath>

#include "draw.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/toml/rig_writer.hpp"
#include "host_sim/records/csv/csv_writer.hpp"
#include "noise.hpp"

namespace {

using namespace hidden_rig;

TrueRig one_mass(double c, double F) {
  TrueRig rig;
  rig.mass_kg = {2};
  TrueLink link;
  link.k = 800, link.c = c, link.F = F;  // 20 rad/s
  rig.links = {link};
  return rig;
}

Drive let_go(double x) {
  Drive drive;
  drive.force_N.resize(1);
  drive.start_x = {x};
  drive.start_v = {0};
  return drive;
}

// x = e^(-z w t) (cos wd t + z w / wd sin wd t) with z w = c / 2m = 0.5, w = 20.
TEST(HiddenRig, DecaysAsTheFormulaOfOneMassSays) {
  const Motion m = integrate(one_mass(2, 0), let_go(1e-2), 2000, 0);
  const double wd = std::sqrt(400 - 0.25);
  for (size_t i = 0; i < 2000; i += 37) {
    const double t = static_cast<double>(i) * 1e-3;
    EXPECT_NEAR(m.x[0][i], 1e-2 * std::exp(-0.5 * t) * (std::cos(wd * t) + 0.5 / wd * std::sin(wd * t)), 1e-12);
  }
}

// Dry friction alone: every half cycle (pi / 20 s) takes 2 F / k = 2 mm from 10.5 mm: 10.5, -8.5, 6.5, -4.5, 2.5, -0.5; there
// k |x| = 0.4 N < F = 0.8 N holds it for ever.
TEST(HiddenRig, DryFrictionTakesTwiceItsDeflectionEachHalfCycleAndThenHolds) {
  const Motion m = integrate(one_mass(0, 0.8), let_go(10.5e-3), 1000, 0);
  EXPECT_NEAR(m.x[0][314], 6.5e-3, 1e-7);  // 0.31416 s is two half cycles: a maximum
  for (size_t i = 786; i < 1000; ++i) {    // five of them are 0.7854 s
    ASSERT_NEAR(m.x[0][i], -0.5e-3, 1e-8);
    ASSERT_EQ(m.a[0][i], 0.0);
    ASSERT_NEAR(m.v[0][i], 0.0, 1e-12);
    ASSERT_NEAR(m.damping_force[0][i], 0.4, 1e-5);  // friction holds what the spring pulls
  }
  EXPECT_NEAR(m.stuck_share[0], 0.215, 0.002);
}

// A force below the friction level moves nothing; a rotating mass turns at an unbalance only.
TEST(HiddenRig, AForceBelowTheFrictionMovesNothing) {
  Drive drive;
  drive.force_N = {Values(2 * 4 * 200, 0.7)};
  const Motion m = integrate(one_mass(1, 0.8), drive, 190, 0);
  EXPECT_EQ(rms(m.x[0]), 0.0);
  EXPECT_NEAR(m.damping_force[0][100], 0.7, 1e-12);
}

TEST(HiddenRig, HalfTheStepChangesAStickSlipMotionByLittle) {
  Settings s;
  s.condition = "stick_slip";
  s.masses = 2;
  Draw draw = make_draw(5, s);
  Drive fine = draw.drive[0];
  fine.substeps *= 2;
  Values& f = fine.force_N[0].empty() ? fine.force_N[1] : fine.force_N[0];
  const Values coarse = f;
  f.assign(2 * coarse.size(), 0.0);
  for (size_t i = 0; i + 2 < coarse.size(); i += 2)  // the same parabolas at half the step
    for (size_t j = 0; j < 4; ++j) {
      const double r = 0.25 * static_cast<double>(j), a = coarse[i], b = coarse[i + 1], c = coarse[i + 2];
      f[2 * i + j] = a + r * (-3 * a + 4 * b - c) + 2 * r * r * (a - 2 * b + c);
    }
  const Motion m = integrate(draw.true_rig, fine, 3000, 1000);
  const double level = rms(draw.motion[0].x[0]);
  for (size_t i = 0; i < 3000; i += 10) ASSERT_NEAR(m.x[0][i], draw.motion[0].x[0][i], 1e-4 * level) << i;
}

TEST(HiddenRig, EveryConditionIsDrawnAndItsCoefficientsHaveTheRigFilesNames) {
  for (const Condition& c : conditions()) {
    if (c.seconds * c.rate_Hz * c.most_masses > 250000) continue;  // the long ones: in benches
    Settings s;
    s.condition = c.name;
    s.sensors = "mixed";
    const Draw draw = make_draw(11, s);
    ASSERT_EQ(draw.records.size(), static_cast<size_t>(c.records)) << c.name;
    const std::vector<std::string> names = rig_file::parameter_names(draw.rig);
    ASSERT_EQ(draw.coefficients.size(), names.size()) << c.name;
    for (size_t i = 0; i < names.size(); ++i) EXPECT_EQ(draw.coefficients[i].name, names[i]);
    for (const host_sim::Record& record : draw.records) {
      EXPECT_GE(record.samples(), 200u) << c.name;
      EXPECT_NEAR(record.sample_period_s * c.rate_Hz, 1, 1e-12);
      for (const host_sim::Channel& channel : record.channels) EXPECT_GT(rms(channel.values), 0) << c.name;
    }
    EXPECT_TRUE(draw.hidden.empty());
  }
}

TEST(HiddenRig, EveryEffectIsHiddenWithTheStrengthAskedFor) {
  for (const std::string& kind : effects()) {
    Settings s;
    s.condition = kind == "missing_gravity_torque" ? "rotation" : "seconds_2";
    s.hidden = kind;
    const Draw draw = make_draw(3, s);
    ASSERT_EQ(draw.hidden.size(), 1u) << kind;
    EXPECT_EQ(draw.hidden[0].effect, kind == "force_delay" ? "sensor_delay" : kind);
    if (draw.hidden[0].where.rfind("channel", 0) == 0 && kind != "drive_dead_band") continue;
    EXPECT_GE(draw.hidden[0].rho, 0.045) << kind;
    EXPECT_LE(draw.hidden[0].rho, 0.66) << kind;
  }
}

TEST(HiddenRig, NoiseHasUnitVarianceAndItsColour) {
  Dice dice(1);
  const auto correlation = [](const Values& v) {
    double sum = 0;
    for (size_t i = 1; i < v.size(); ++i) sum += v[i] * v[i - 1];
    return sum / static_cast<double>(v.size()) / (rms(v) * rms(v));
  };
  const Values white = draw_noise(dice, condition("random_1pct"), 40000);
  const Values first = draw_noise(dice, condition("ar_0p8_1pct"), 40000);
  EXPECT_NEAR(rms(white), 1, 0.02);
  EXPECT_NEAR(rms(first), 1, 0.05);
  EXPECT_NEAR(correlation(white), 0, 0.02);
  EXPECT_NEAR(correlation(first), 0.8, 0.02);
}

// Second-order sections of a Butterworth: 1 / sqrt 2 at the corner, one at rest.
TEST(HiddenRig, TheAntiAliasFilterHalvesThePowerAtItsCorner) {
  Values tone(4000), rest(100, 3.0);
  for (size_t i = 0; i < tone.size(); ++i) tone[i] = std::sin(6.283185307179586 * 0.2 * static_cast<double>(i));
  low_pass(tone, 0.2);
  low_pass(rest, 0.2);
  EXPECT_NEAR(rms(Values(tone.begin() + 500, tone.end())), 0.5, 1e-3);
  EXPECT_NEAR(rest[99], 3, 1e-9);
}

TEST(HiddenRig, TheSameSeedGivesTheSameBytes) {
  Settings s;
  s.condition = "seconds_2";
  s.hidden = "any";
  const Draw one = make_draw(21, s), two = make_draw(21, s), other = make_draw(22, s);
  EXPECT_EQ(host_sim::format_csv(one.records[0]), host_sim::format_csv(two.records[0]));
  EXPECT_EQ(truth_json(21, s, one), truth_json(21, s, two));
  EXPECT_NE(rig_file::format_rig(one.rig), rig_file::format_rig(other.rig));
}

TEST(HiddenRig, WarmingChangesTheViscousCoefficientsFromRecordToRecord) {
  Settings s;
  s.condition = "warming_records";
  const Draw draw = make_draw(2, s);
  for (const TrueCoefficient& c : draw.coefficients) {
    if (c.name.rfind("viscous", 0) != 0) continue;
    EXPECT_NEAR(c.of_record.back() / c.of_record.front(), 1.075 / 0.925, 1e-9);
    EXPECT_NEAR(c.value, c.of_record[2], 1e-9 * c.value);
  }
}

TEST(HiddenRig, AnUnknownNameIsRefusedWithTheKnownOnes) {
  Settings s;
  s.condition = "moon_base";
  try {
    make_draw(1, s);
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("moving_base"), std::string::npos);
  }
}

}  // namespace
