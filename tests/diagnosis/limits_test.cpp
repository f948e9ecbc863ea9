// What a "none" promises: stronger would have been named, weaker need not have been, and some could not be seen at all.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "judgement.hpp"

namespace hidden {
namespace {

using diagnosis::DetectionLimit;
using diagnosis::Diagnosis;

Draw nothing(uint64_t seed, const std::string& sensors) {
  Settings settings;
  settings.hide = Hide::kNothing, settings.sensors = sensors;
  return make_draw(seed, settings);
}

const DetectionLimit* find(const Diagnosis& d, const std::string& effect, const std::string& where) {
  for (const DetectionLimit& l : d.minimum_detectable)
    if (l.effect == effect && l.where == where) return &l;
  return nullptr;
}

TEST(Limits, NoneListsWhatWouldHaveBeenSeen) {
  const Draw draw = nothing(12, "xva");
  const Diagnosis answer = answer_to(draw);
  ASSERT_EQ(answer.verdict, diagnosis::Verdict::kNone) << told(draw, answer);
  for (const char* effect : {"cubic_stiffness", "end_stop", "force_offset", "asymmetric_viscous", "drifting_viscous"})
    EXPECT_NE(find(answer, effect, "link 1-0"), nullptr) << effect;
  for (const char* fault : {"sensor_delay", "sensor_gain", "mains_hum"})
    for (const char* channel : {"channel displacement_1_m", "channel velocity_1_m_s", "channel acceleration_1_m_s2", "channel force_1_N"})
      EXPECT_NE(find(answer, fault, channel), nullptr) << fault << " of " << channel;
  for (const DetectionLimit& limit : answer.minimum_detectable) {
    EXPECT_EQ(find(answer, limit.effect, limit.where), &limit) << limit.effect << " twice on " << limit.where;
    EXPECT_GT(limit.strength, 0) << limit.effect << " " << limit.where;
    EXPECT_TRUE(std::isfinite(limit.strength)) << limit.effect << " " << limit.where;
    EXPECT_FALSE(limit.unit.empty());
  }
}

// Integrated acceleration has no mean: a constant force leaves no trace. A wrong gain of one accelerometer of several is not
// what the springs and masses between them want.
TEST(Limits, NoneSaysWhatAccelerationAloneCannotShow) {
  const Draw draw = nothing(13, "a");
  const Diagnosis answer = answer_to(draw);
  ASSERT_EQ(answer.verdict, diagnosis::Verdict::kNone) << told(draw, answer);
  const DetectionLimit* offset = find(answer, "force_offset", "link 1-0");
  const DetectionLimit* gain = find(answer, "sensor_gain", "channel acceleration_1_m_s2");
  ASSERT_NE(offset, nullptr);
  ASSERT_NE(gain, nullptr);
  EXPECT_TRUE(std::isinf(offset->strength));
  EXPECT_GT(gain->strength, 1e-4);
  EXPECT_LT(gain->strength, 0.02);
  EXPECT_EQ(answer.advice.size(), 2u);  // longer records, displacement
  const nlohmann::json written = nlohmann::json::parse(to_json(answer).dump());
  int unseen = 0;
  for (const nlohmann::json& limit : written["minimum_detectable"]) unseen += limit["strength"].is_null();
  EXPECT_GE(unseen, 1);
}

// A gain error of 1.6 times the limit is five standard deviations and three more away from nought; of 0.3 times two.
TEST(Limits, AGainErrorAboveItsLimitIsNamedAndOneFarBelowIsNot) {
  for (uint64_t seed : {21, 22, 23}) {
    double lowest = 1, highest = 0;
    for (const DetectionLimit& l : answer_to(nothing(seed, "xva")).minimum_detectable)
      if (l.effect == "sensor_gain" && l.where != "channel force_1_N") lowest = std::min(lowest, l.strength), highest = std::max(highest, l.strength);
    Settings settings;
    settings.hide = Hide::kSensorFault, settings.kind = "sensor_gain", settings.channel = "velocity_1_m_s";
    settings.rho_low = settings.rho_high = 1.6 * highest;
    const Draw above = make_draw(seed, settings);
    const Diagnosis found = answer_to(above);
    EXPECT_NE(judge(above, found), Outcome::kWrong) << told(above, found);
    settings.rho_low = settings.rho_high = 0.3 * lowest;
    EXPECT_EQ(answer_to(make_draw(seed, settings)).verdict, diagnosis::Verdict::kNone);
  }
}

}  // namespace
}  // namespace hidden
