// The picture from single frames: what is known, when the wire was away, what is told.
#include "host_sim/live/state/bus_picture.hpp"

#include <gtest/gtest.h>

#include "tests/live/frames.hpp"

namespace live {
namespace {

std::vector<std::string> told(const BusPicture& picture) {
  std::vector<std::string> texts;
  for (const Event& event : picture.events()) texts.push_back(event.text);
  return texts;
}

TEST(BusPicture, KnowsTheEstimatesByTheirNames) {
  BusPicture picture;
  picture.take(frames::at(1.0, frames::estimate(1, 20001, 12)));
  EXPECT_EQ(picture.estimate_name(1, 1), "estimate 1");
  picture.take(frames::at(1.1, frames::name(1, firmware::TermKind::kViscous, 1, 2)));
  ASSERT_EQ(picture.node(1).estimates.size(), 2u);  // index 0 has not come
  EXPECT_EQ(picture.node(1).estimates[0].status, "");
  EXPECT_DOUBLE_EQ(picture.node(1).estimates[1].value, 20.001);
  EXPECT_DOUBLE_EQ(picture.node(1).estimates[1].std, 0.012);
  EXPECT_EQ(picture.node(1).estimates[1].status, "VALID");
  EXPECT_EQ(picture.estimate_name(1, 1), "viscous[1-2]");
  EXPECT_EQ(picture.estimate_unit(1, 1), "N s/m");
  EXPECT_EQ(picture.nodes(), std::vector<int>{1});
}

TEST(BusPicture, EstimatesOfAFdFrameAreThoseThatArePresent) {
  firmware::Estimates estimates;
  estimates.unknown_count = 9;
  for (auto& parameter : estimates.parameters) parameter.value = firmware::Scaled::from_int(3);
  BusPicture picture;
  picture.take(frames::at(1.0, firmware::pack_estimates_fd(2, 1, estimates)));
  ASSERT_EQ(picture.node(2).estimates.size(), 9u);  // index 8 is the first of the second frame; 9 to 15 are unused
  EXPECT_DOUBLE_EQ(picture.node(2).estimates[8].value, 3.0);
}

// Heartbeats to 1.0 s, then nothing until 4.2 s: silent from the last frame on, noticed a second later.
TEST(BusPicture, AGapInALogIsSilence) {
  BusPicture picture;
  for (int i = 0; i <= 10; ++i) picture.take(frames::at(0.1 * i, frames::heartbeat()));
  EXPECT_EQ(picture.link().phase(), BusPhase::kUp);
  picture.take(frames::at(4.2, frames::heartbeat()));
  EXPECT_EQ(told(picture), (std::vector<std::string>{"bus silent", "bus back after 3.2 s"}));
  EXPECT_NEAR(static_cast<double>(picture.events()[0].time_ns), 2.0e9, 10.0);
  EXPECT_EQ(picture.link().phase(), BusPhase::kUp);
  EXPECT_EQ(picture.link().absences(), 1);
}

TEST(BusPicture, SilenceIsNoticedWhileItLasts) {
  BusPicture picture;
  picture.take(frames::at(1.0, frames::heartbeat()));
  picture.advance(1900000000);
  EXPECT_EQ(picture.link().phase(), BusPhase::kUp);
  EXPECT_FALSE(picture.node_silent(1));
  picture.advance(2100000000);
  EXPECT_EQ(picture.link().phase(), BusPhase::kSilent);
  EXPECT_TRUE(picture.node_silent(1));
  EXPECT_EQ(picture.link().phase_since_ns(), 1000000000u);
}

TEST(BusPicture, BusOffLastsUntilTheControllerIsRestarted) {
  BusPicture picture;
  picture.take(frames::at(1.0, frames::heartbeat()));
  picture.take(frames::error_at(1.5, 0x040));
  EXPECT_EQ(picture.link().phase(), BusPhase::kOff);
  picture.take(frames::error_at(2.0, 0x100));
  EXPECT_EQ(picture.link().phase(), BusPhase::kUp);
  EXPECT_EQ(told(picture), (std::vector<std::string>{"bus-off", "bus back after 0.5 s"}));
  EXPECT_EQ(picture.link().error_frames(), 2u);
}

TEST(BusPicture, AnInterfaceThatIsDownIsToldOnce) {
  BusPicture picture;
  picture.take(frames::at(1.0, frames::heartbeat()));
  picture.link_down(1200000000);
  picture.link_down(1300000000);
  picture.advance(5000000000);
  EXPECT_EQ(picture.link().phase(), BusPhase::kDown);
  picture.take(frames::at(6.2, frames::heartbeat()));
  EXPECT_EQ(told(picture), (std::vector<std::string>{"interface down", "bus back after 5.0 s"}));
}

// A heartbeat of one byte is at most 47 + 8 + (34 + 8 - 1) / 4 = 65 bits, 130 us at 500 kbit/s; a hundred in a second
// are 13 ms of it: 1.3 %.
TEST(BusPicture, LoadOfTheLastSecond) {
  BusPicture picture;
  for (int i = 0; i < 300; ++i) picture.take(frames::at(0.01 * i, frames::heartbeat()));
  EXPECT_NEAR(picture.link().load_percent(), 1.3, 1e-9);
  EXPECT_NEAR(picture.link().frames_per_s(), 100.0, 1e-9);
  picture.advance(3500000000);  // half of them are older than a second now
  EXPECT_NEAR(picture.link().load_percent(), 0.65, 0.014);
}

// The clock is set back amid the log: a hundred frames a second before and behind, and half a second behind it still are.
TEST(BusPicture, LoadAfterTimesHaveJumpedBack) {
  BusPicture picture;
  for (int i = 0; i < 300; ++i) picture.take(frames::at(100.0 + 0.01 * i, frames::heartbeat()));
  for (int i = 0; i <= 50; ++i) picture.take(frames::at(0.01 * i, frames::heartbeat()));
  EXPECT_NEAR(picture.link().frames_per_s(), 51 / 0.5, 1e-9);
  for (int i = 51; i < 300; ++i) picture.take(frames::at(0.01 * i, frames::heartbeat()));
  EXPECT_NEAR(picture.link().frames_per_s(), 100.0, 1e-9);
  EXPECT_NEAR(picture.link().load_percent(), 1.3, 1e-9);
}

TEST(BusPicture, AlarmsAreToldWithTheirChannel) {
  firmware::Emergency emergency;
  emergency.code = firmware::EmergencyCode::kSensorSaturated;
  emergency.place = 3;
  emergency.quantity = 2;
  emergency.detail = 1000;
  BusPicture picture;
  picture.take(frames::at(1.0, firmware::pack_emergency(2, emergency)));
  picture.take(frames::at(1.5, firmware::pack_emergency(2, firmware::Emergency{})));
  EXPECT_EQ(told(picture), (std::vector<std::string>{"SENSOR_SATURATED, velocity[3] (1000)", "NO_ERROR"}));
  EXPECT_TRUE(picture.events()[0].bad);
  EXPECT_FALSE(picture.events()[1].bad);
  EXPECT_EQ(picture.events()[0].node, 2);
}

TEST(BusPicture, EventsAreForgottenFromTheOldest) {
  BusPicture picture;
  for (int i = 0; i < 150; ++i) picture.take(frames::at(0.1 * i, firmware::pack_emergency(1, firmware::Emergency{})));
  EXPECT_EQ(picture.events().size(), BusPicture::kMostEvents);
  EXPECT_NEAR(static_cast<double>(picture.events().front().time_ns), 5.0e9, 10.0);
}

TEST(Trend, KeepsItsSpanAndItsNewestPoint) {
  Trend trend;
  for (uint64_t i = 0; i < 5000; ++i) trend.add(i * 1000, static_cast<double>(i), 4000000);
  EXPECT_LE(trend.points().size(), Trend::kMostPoints);
  EXPECT_GE(trend.points().size(), Trend::kMostPoints / 2);
  EXPECT_EQ(trend.points().back().value, 4999.0);
  EXPECT_GE(trend.points().front().time_ns, 999000u);
  trend.add(10, 7.0, 4000000);  // time goes back: another log
  EXPECT_EQ(trend.points().size(), 1u);
}

// Whatever arrives, nothing is read or written outside (this test is for the sanitizers).
TEST(BusPicture, RandomFramesAreSurvived) {
  BusPicture picture;
  uint32_t state = 1;
  const auto random = [&] { return state = state * 1664525u + 1013904223u, state >> 8; };
  for (int i = 0; i < 50000; ++i) {
    firmware::CanFrame message;
    message.id = random() % 0x800;
    message.fd = random() % 4 == 0;
    message.length = static_cast<uint8_t>(random() % (message.fd ? 65 : 9));
    for (uint8_t& byte : message.data) byte = static_cast<uint8_t>(random());
    picture.take(frames::at(0.001 * i, message));
  }
  EXPECT_EQ(picture.link().frames(), 50000u);
}

}  // namespace
}  // namespace live
