// The screen as lines of text: every width is kept, what matters stands on it.
#include "host_sim/live/screen/screen.hpp"

#include <gtest/gtest.h>

#include "host_sim/live/screen/trend_line.hpp"
#include "tests/live/frames.hpp"

namespace live {
namespace {

std::string text_of(const std::vector<Line>& lines) {
  std::string text;
  for (const Line& line : lines) text += plain_text(line) + "\n";
  return text;
}

// Two parameters, a status with a fault, a diagnosis, an alarm.
BusPicture rig() {
  BusPicture picture;
  picture.take(frames::at(10.0, frames::heartbeat()));
  picture.take(frames::at(10.0, frames::name(0, firmware::TermKind::kViscous, 1, 2)));
  picture.take(frames::at(10.0, frames::name(1, firmware::TermKind::kCoulomb, 3, 0)));
  for (int i = 0; i < 8; ++i) {
    picture.take(frames::at(10.1 + 0.1 * i, frames::estimate(0, 20000 + i * 100, 10)));
    picture.take(frames::at(10.1 + 0.1 * i, frames::estimate(1, 1005, 500, firmware::EstimateStatus::kSkewed)));
  }
  firmware::NodeStatus status;
  status.mode = firmware::ControllerMode::kIntegrate;
  status.faults = firmware::fault_bit(firmware::Fault::kSamplesMissed);
  status.condition_log2 = 4;
  picture.take(frames::at(10.9, firmware::pack_status(1, status)));
  firmware::NodeHealth health;
  health.uptime_s = 3725;
  health.core.missed_samples = 7;
  picture.take(frames::at(10.9, firmware::pack_health(1, health)));
  firmware::Diagnosis diagnosis;
  diagnosis.cause = firmware::cause_of(firmware::EffectKind::kStiffnessError);
  diagnosis.place_a = 1;
  diagnosis.place_b = 2;
  diagnosis.unexplained_permille = 123;
  picture.take(frames::at(10.9, firmware::pack_diagnosis(1, diagnosis)));
  firmware::Emergency emergency;
  emergency.code = firmware::EmergencyCode::kSamplesMissed;
  emergency.detail = 7;
  picture.take(frames::at(10.9, firmware::pack_emergency(1, emergency)));
  return picture;
}

View view(int width, int height = 0) {
  View result;
  result.width = width;
  result.height = height;
  result.source = "can0";
  result.prompt = "q quit";
  return result;
}

// 95 %: 1.96 * 0.01 = 0.0196 -> 0.02; 1.96 * 0.5 = 0.98. Eight columns of the trend for 8 values: first to last level.
TEST(Screen, SaysWhatMatters) {
  const std::string text = text_of(draw(rig(), view(80)));
  for (const char* words :
       {"host_sim watch can0", "bus up", "load at most", "node 1  OPERATIONAL  INTEGRATE  faults: SAMPLES_MISSED",
        "up 1:02:05", "missed samples 7", "condition 2^4", "viscous[1-2] 20.700 ±0.02 N s/m VALID ", "coulomb[3-0]",
        "±0.98", "SKEWED", "diagnosis: stiffness_error on link 1-2 (unexplained 12.3 %)",
        "alarms:", "0.9 s  node 1  SAMPLES_MISSED (7)", "q quit"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
}

TEST(Screen, KeepsEveryWidthAndHeight) {
  const BusPicture picture = rig();
  for (const bool unicode : {true, false})
    for (int width = 20; width <= 220; ++width)
      for (const int height : {0, 8, 24, 50}) {
        View v = view(width, height);
        v.unicode = unicode;
        const std::vector<Line> lines = draw(picture, v);
        for (const Line& line : lines) EXPECT_LE(columns_of(line), std::max(width, 60)) << width << plain_text(line);
        if (height >= 24) {
          EXPECT_EQ(static_cast<int>(lines.size()), height);
        }
        if (unicode) continue;
        for (const char c : text_of(lines)) EXPECT_LT(static_cast<unsigned char>(c), 128u);
      }
}

TEST(Screen, ATableThatDoesNotFitScrolls) {
  BusPicture picture;
  for (int k = 0; k < 48; ++k) picture.take(frames::at(1.0, frames::estimate(k, 1000 * k, 10)));
  View v = view(80, 24);
  EXPECT_NE(text_of(draw(picture, v)).find("estimate 0 "), std::string::npos);
  EXPECT_EQ(text_of(draw(picture, v)).find("estimate 47 "), std::string::npos);
  v.first_row = last_first_row(picture, v);
  EXPECT_GT(v.first_row, 20);
  const std::string end = text_of(draw(picture, v));
  EXPECT_NE(end.find("estimate 47 "), std::string::npos) << end;
  EXPECT_NE(end.find("to 48 of 48"), std::string::npos) << end;
  v.first_row = 1000;  // beyond the end
  EXPECT_EQ(text_of(draw(picture, v)), end);
}

TEST(Screen, LongNamesAreCutAndNumbersNever) {
  BusPicture picture;
  picture.take(frames::at(1.0, frames::name(0, firmware::TermKind::kDisplacementDependentDamping, 10, 11)));
  picture.take(frames::at(1.0, frames::estimate(0, -123456, 20000, firmware::EstimateStatus::kIllConditioned)));
  const std::string text = text_of(draw(picture, view(60)));
  EXPECT_NE(text.find("displacement_dep"), std::string::npos) << text;
  EXPECT_NE(text.find("…"), std::string::npos) << text;
  EXPECT_NE(text.find("-123 "), std::string::npos) << text;
  EXPECT_NE(text.find("±39 "), std::string::npos) << text;
  EXPECT_NE(text.find("ILL_CONDITIONED"), std::string::npos) << text;
}

TEST(Screen, ShowsTheWireGoneAndANodeSilent) {
  BusPicture picture = rig();
  picture.advance(13400000000);
  const std::string text = text_of(draw(picture, view(60)));
  EXPECT_NE(text.find("BUS SILENT for 2.5 s"), std::string::npos) << text;
  EXPECT_NE(text.find("node 1  SILENT for 2.5 s"), std::string::npos) << text;
  EXPECT_NE(text.find("bus     bus silent"), std::string::npos) << text;
}

TEST(Screen, BeforeTheFirstFrame) {
  const std::string text = text_of(draw(BusPicture(), view(60, 24)));
  EXPECT_NE(text.find("waiting for the first frame"), std::string::npos) << text;
  EXPECT_NE(text.find("no estimates yet"), std::string::npos) << text;
}

// 0 to 7 over eight columns: the eight levels. Changes below four standard deviations stay in the middle.
TEST(TrendLine, LevelsFromLowToHigh) {
  Trend trend;
  for (uint64_t i = 0; i < 8; ++i) trend.add(i * 1000000000, static_cast<double>(i), 100000000000);
  EXPECT_EQ(trend_line(trend, 0.0, 7999999999, 100000000000, 8, false), "_.-=+*%#");
  EXPECT_EQ(trend_line(trend, 0.0, 7999999999, 100000000000, 8, true), "▁▂▃▄▅▆▇█");
  // std 7: the range is 28 wide, from -10.5 to 17.5; 0 is at 0.375 * 8 = 3, 7 at 0.625 * 8 = 5.
  EXPECT_EQ(trend_line(trend, 7.0, 7999999999, 100000000000, 8, false), "====+++*");
  // Only the last four seconds, one column each: 4 to 7 (3 ended before).
  EXPECT_EQ(trend_line(trend, 0.0, 8000000000, 4000000000, 4, false), "_-*#");
  EXPECT_EQ(trend_line(Trend(), 0.0, 1, 1, 3, false), "   ");
}

}  // namespace
}  // namespace live
