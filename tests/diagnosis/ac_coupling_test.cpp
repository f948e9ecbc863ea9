// An accelerometer behind a high-pass, as one with built-in electronics is, beside a channel that is not: told by the two of
// them, before any equation.
#include "host_sim/records/ac_coupling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/diagnosis/sensors/ac_coupling.hpp"
#include "judgement.hpp"
#include "tests/data_check/pass_high.hpp"

namespace hidden {
namespace {

Draw behind(const char* channel, double corner_Hz, const char* sensors, uint64_t seed) {
  Settings s;
  s.hide = Hide::kNothing, s.sensors = sensors, s.dofs = 2;
  Draw draw = make_draw(seed, s);
  for (host_sim::Channel& c : draw.record.channels)
    if (c.name == channel) made::pass_high(c.values, corner_Hz, draw.record.sample_period_s);
  return draw;
}

void expect_named(const diagnosis::Diagnosis& d, const std::string& channel, double corner_Hz, const std::string& who) {
  ASSERT_EQ(d.causes.size(), 1u) << who;
  EXPECT_EQ(d.causes[0].effect, "ac_coupling") << who;
  EXPECT_EQ(d.causes[0].where, "channel " + channel) << who;
  EXPECT_EQ(d.verdict, diagnosis::Verdict::kExplained) << who;
  const diagnosis::Parameter& corner = d.causes[0].parameters.at(0);
  EXPECT_EQ(corner.unit, "Hz");
  EXPECT_NEAR(corner.value, corner_Hz, 4 * corner.std + 0.01 * corner_Hz) << who;  // 1 %: how its start rings off
}

// Truth outside four deviations is one in 16,000 by chance.
void expect_true_dampers(const Draw& draw, const diagnosis::Diagnosis& d, const std::string& who) {
  for (const TrueLink& l : draw.true_rig.links)
    for (const diagnosis::Parameter& p : d.extended.parameters)
      if (p.name == "viscous[" + std::to_string(l.a + 1) + "-" + std::to_string(l.b + 1) + "]") {
        EXPECT_NEAR(p.value, l.c, 4 * p.std) << p.name << " " << who;
      }
}

}  // namespace

TEST(AcCoupling, OfAnAccelerometerIsNamedAndTakenOut) {
  for (const char* sensors : {"xva", "xa", "va"})
    for (double corner_Hz : {0.3, 1.0}) {
      const Draw draw = behind("acceleration_1_m_s2", corner_Hz, sensors, 31);
      const diagnosis::Diagnosis d = answer_to(draw);
      const std::string who = sensors + std::string(" ") + std::to_string(corner_Hz) + " " + told(draw, d);
      expect_named(d, "acceleration_1_m_s2", corner_Hz, who);
      expect_true_dampers(draw, d, who);
    }
}

// Force cell and accelerometers of one make: alike in all of them, it bends no equation but those of the displacements.
TEST(AcCoupling, OfTheForceIsThatOfTheAccelerometers) {
  Draw draw = behind("", 0, "xa", 35);
  for (host_sim::Channel& c : draw.record.channels)
    if (c.quantity == host_sim::Quantity::kForce || c.quantity == host_sim::Quantity::kAcceleration)
      made::pass_high(c.values, 0.5, draw.record.sample_period_s);
  const diagnosis::Diagnosis d = answer_to(draw);
  EXPECT_TRUE(d.names("ac_coupling", "channel force_1_N")) << told(draw, d);
  EXPECT_EQ(d.causes.size(), 3u) << told(draw, d);
  expect_true_dampers(draw, d, told(draw, d));
}

// With the key that the extended rig file has, the record holds nothing to find.
TEST(AcCoupling, JoinsTheRigFile) {
  Draw draw = behind("acceleration_1_m_s2", 0.5, "xa", 33);
  const diagnosis::Diagnosis d = answer_to(draw);
  const auto stated = host_sim::stated_ac_couplings(d.extended_rig);
  ASSERT_EQ(stated.size(), 1u) << told(draw, d);
  std::vector<host_sim::Record> records{draw.record};
  host_sim::undo_ac_coupling(stated, records);
  draw.record = records[0];
  const diagnosis::Diagnosis again = answer_to(draw);
  EXPECT_EQ(again.verdict, diagnosis::Verdict::kNone) << told(draw, again);
}

// Where nothing of the kind is there, what could have been seen is told.
TEST(AcCoupling, IsLookedForInEveryRecord) {
  const Draw draw = behind("", 0, "xva", 34);
  const diagnosis::Diagnosis d = answer_to(draw);
  EXPECT_EQ(d.verdict, diagnosis::Verdict::kNone) << told(draw, d);
  const auto limit = std::find_if(d.minimum_detectable.begin(), d.minimum_detectable.end(), [](const auto& l) {
    return l.effect == "ac_coupling" && l.where == "channel acceleration_1_m_s2";
  });
  ASSERT_NE(limit, d.minimum_detectable.end());
  EXPECT_GT(limit->strength, 0);
  EXPECT_LT(limit->strength, 0.3);
  EXPECT_EQ(limit->unit, "Hz");
}

// 4 +- 0.1 N s/m reaches from 3.804 to 4.196. A cause has to take 30 % of what unseen data are missed by.
TEST(AcCoupling, MattersWhereItMovesANumberOrPays) {
  diagnosis::Diagnosis as_recorded, undone;
  as_recorded.baseline.parameters = {{"viscous[1-0]", 4.0, "N s/m", 0.1}, {"mass[1]", 2.0, "kg", 0.0, false}};
  as_recorded.baseline.holdout_nrmse_percent = {2.0};
  undone = as_recorded;
  undone.baseline.parameters[0].value = 4.19, undone.baseline.parameters[1].value = 3.0;
  undone.baseline.holdout_nrmse_percent = {1.5};
  EXPECT_FALSE(diagnosis::undoing_matters(undone, as_recorded));
  undone.baseline.parameters[0].value = 4.2;
  EXPECT_TRUE(diagnosis::undoing_matters(undone, as_recorded));
  undone.baseline.parameters[0].value = 4.0, undone.baseline.holdout_nrmse_percent = {1.3};
  EXPECT_TRUE(diagnosis::undoing_matters(undone, as_recorded));
  undone.baseline.parameters.erase(undone.baseline.parameters.begin());  // a number that is told no more
  undone.baseline.holdout_nrmse_percent = {2.0};
  EXPECT_TRUE(diagnosis::undoing_matters(undone, as_recorded));
}

}  // namespace hidden
