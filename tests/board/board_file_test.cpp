// The board's file: what a good one makes of the controller.
#include "hal/linux/board/board_file.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "hal/linux/board/bus_check.hpp"
#include "hal/linux/board/output_sections.hpp"
#include "hal/linux/board/run_marker.hpp"
#include "hal/linux/board/safe_outputs.hpp"
#include "hal/rig_file/rig_file_error.hpp"
#include "tests/board/board_file_fixture.hpp"

namespace {

using board_test::BoardFileTest;
using board_test::kGood;

TEST_F(BoardFileTest, TheBudgetOfTheModelTestsIsAKey) {
  EXPECT_EQ(read(kGood).controller.core.probe_products_per_sample, firmware::kDefaultProbes);
  std::string text = kGood;
  text.replace(text.find("id = 3"), 6, "id = 3\nprobe_products_per_sample = 140");
  EXPECT_EQ(read(text).controller.core.probe_products_per_sample, 140);
}

TEST_F(BoardFileTest, AGoodFileBecomesIntegers) {
  const board::BoardFile board = read(kGood);
  const firmware::ControllerConfiguration& controller = board.controller;
  EXPECT_EQ(controller.node.node, 3);
  EXPECT_EQ(controller.node.window_samples, 1000u);  // 0.5 s of 2 kHz
  EXPECT_TRUE(controller.node.drive_on_can);
  EXPECT_EQ(board.can_interface, "vcan1");
  EXPECT_EQ(board.samples.wiring, firmware::SensorWiring::k24);
  EXPECT_EQ(controller.limits.sample_timeout_us, 2500u);
  EXPECT_EQ(controller.limits.response_limit_code[0][0], 7000000);
  EXPECT_EQ(controller.core.channels[0][1].offset_code, -12);
  EXPECT_EQ(board.emergency_stop.line, "stop");
  EXPECT_TRUE(board.emergency_stop.options.active_low);
  EXPECT_EQ(board.emergency_stop.options.bias, hal::LineBias::kPullUp);
  EXPECT_EQ(board.relay.line, "gpiochip0:4");
  EXPECT_FALSE(board.relay.options.active_low);
  EXPECT_EQ(controller.programme.level_count, 1);
  EXPECT_FALSE(controller.programme.start_at_boot);
  EXPECT_EQ(controller.programme.limits.magnitude.raw, 1 << 30);          // 0.5 of 2^31
  EXPECT_EQ(controller.programme.limits.step_per_sample.raw, 107374182);  // 100 / 2000 = 0.05 of 2^31, rounded
  const firmware::ExcitationLevel& level = controller.programme.levels[0];
  EXPECT_EQ(level.amplitude.raw, 1 << 29);  // 0.25 of 2^31
  EXPECT_EQ(level.phase_step, 10737418u);   // 2^32 * 5 / 2000 = 10737418.24
  EXPECT_EQ(level.ramp_samples, 4000u);
  EXPECT_EQ(level.measure_samples, 60000u);
  EXPECT_EQ(level.settle.block_samples, 1200u);  // 0.5 s is 2.5 cycles: three whole ones, 0.6 s
  EXPECT_EQ(controller.core.window.mode, firmware::WindowMode::kWholeCycles);
  // 400 samples a cycle, as a fraction.
  EXPECT_EQ(controller.core.window.cycle_samples_numerator, 400u * controller.core.window.cycle_samples_denominator);
}

// 10 ms of silence are two samples of 200 Hz: three periods then. At 2 kHz 10 ms.
TEST_F(BoardFileTest, SilenceIsTimedInPeriodsOfSlowSamples) {
  const std::string untold = changed("timeout_ms = 2.5\n", "");
  EXPECT_EQ(read(untold).controller.limits.sample_timeout_us, 10000u);
  std::string slow = untold;
  slow.replace(slow.find("rate_Hz = 2000"), 14, "rate_Hz = 200");
  slow.replace(slow.find("frequency_Hz = 5"), 16, "frequency_Hz = 1");
  EXPECT_EQ(read(slow).controller.limits.sample_timeout_us, 15000u);
}

// 2 kHz over 1 mHz: 2,000,000 samples a cycle, whose product with 1024 is beyond 32 bits.
TEST_F(BoardFileTest, ACycleMayBeLong) {
  std::string listening = kGood;
  const size_t levels = listening.find("[[excitation.level]]");
  listening.erase(levels, listening.find("[[dof]]") - levels);
  listening.replace(listening.find("rate_Hz = 2000"), 14, "rate_Hz = 2000\ncycle_Hz = 0.001");
  const firmware::WindowConfiguration window = read(listening).controller.core.window;
  EXPECT_EQ(window.mode, firmware::WindowMode::kWholeCycles);
  EXPECT_EQ(window.cycle_samples_numerator, 2000000.0 * window.cycle_samples_denominator);
}

TEST_F(BoardFileTest, TheShippedExampleIsGood) {
  const board::BoardFile board =
      board::read_board_file(std::string(RIG_SOURCE_DIR) + "/hal/linux/packaging/board.example.toml");
  EXPECT_EQ(board.controller.programme.level_count, 2);
  EXPECT_EQ(board.controller.core.window.mode, firmware::WindowMode::kInterval);
}

// By hand: a sensor frame of 8 bytes takes 135 bits at worst, the drive's 125. kGood on a real bus at 2 kHz: 2 * (270 + 125)
// bits each ms and 3 per mille of reports.
TEST_F(BoardFileTest, WhatDoesNotFitItsBusIsRefusedWithWhatWould) {
  const std::string real = changed("\"vcan1\"", "\"can1\"");
  EXPECT_TRUE(board::check_bus(read(kGood)).fits);  // virtual: no bit rate
  EXPECT_FALSE(board::check_bus(read(changed("\"vcan1\"", "\"can1\"\nbit_rate_kbit_s = 500"))).fits);
  const board::BusCheck check = board::check_bus(read(real));
  EXPECT_NE(check.load.find("of 1000 kbit/s at worst: sensor_motion_24 27 %, sensor_force_24 27 %, drive 25 %"),
            std::string::npos)
      << check.load;
}

TEST_F(BoardFileTest, TheShippedExampleFitsAtItsBitRateAlone) {
  const std::string path = std::string(RIG_SOURCE_DIR) + "/hal/linux/packaging/board.example.toml";
  board::BoardFile example = board::read_board_file(path);
  // (4 * 135 + 125) bits each ms of 1 Mbit/s: 66.5 %; reports, size and rival of a diagnosis among them: under 1 %.
  EXPECT_TRUE(board::check_bus(example).fits);
  EXPECT_EQ(board::check_bus(example).load.find("68 % of 1000 kbit/s"), 0u) << board::check_bus(example).load;
  example.bit_rates.nominal = 500000;
  const board::BusCheck slow = board::check_bus(example);
  EXPECT_FALSE(slow.fits);
  for (const char* part : {"bit_rate_kbit_s = 1000 (", "CAN FD sensor frames, wiring = \"fd\" (", "rate_Hz = "})
    EXPECT_NE(slow.instead.find(part), std::string::npos) << part << " | " << slow.instead;
  EXPECT_THROW(board::require_bus(example), rig_file::RigFileError);
  // What is offered holds: at the rate that is named it fits, 10 Hz faster it does not.
  const int rate = std::atoi(slow.instead.c_str() + slow.instead.find("rate_Hz = ") + 10);
  example.samples.rate_Hz = rate;
  EXPECT_TRUE(board::check_bus(example).fits);
  example.samples.rate_Hz = rate + 10;
  EXPECT_FALSE(board::check_bus(example).fits);
  example.bit_rates.nominal = 1000000;
  example.samples.rate_Hz = 5000;
  EXPECT_FALSE(board::check_bus(example).fits);
}

// The unit, the network file and the example agree about the bit rate.
TEST_F(BoardFileTest, TheNetworkFileSetsTheRateThatIsTheDefault) {
  std::ifstream file(std::string(RIG_SOURCE_DIR) + "/hal/linux/packaging/80-rig-can.network");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  EXPECT_NE(text.find("\nBitRate=1M\n"), std::string::npos);
  EXPECT_EQ(read(kGood).bit_rates.nominal, 1000000);
}

// What is needed to make the outputs safe is read from a file whose other parts are broken.
TEST_F(BoardFileTest, OutputsAreReadFromABrokenFile) {
  std::ofstream(folder_ + "/board.toml") << changed("kind = \"sine\"", "kind = \"chirp\"") + "[[dof]]\nmass_kg = -1\n";
  EXPECT_THROW(board::read_board_file(folder_ + "/board.toml"), rig_file::RigFileError);
  std::vector<std::string> problems;
  const board::BoardFile file = board::read_outputs(folder_ + "/board.toml", problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(file.relay.line, "gpiochip0:4");
  EXPECT_EQ(file.drive, board::DriveKind::kCan);
  EXPECT_EQ(file.can_interface, "vcan1");
  EXPECT_EQ(file.controller.node.node, 3);
}

// An output that cannot be reached keeps none of the others from being tried: relay, drive and lamp each say so here.
TEST_F(BoardFileTest, EveryOutputIsTriedWhateverBecomesOfTheOthers) {
  board::BoardFile file = read(changed("[gpio]\n", "[gpio]\nready_lamp = \"no_such_lamp\"\n"));
  file.relay.line = "no_such_relay";
  file.can_interface = "nocan0";
  const std::vector<std::string> faults = board::bring_outputs_to_safe_state(file);
  ASSERT_EQ(faults.size(), 3u);
  EXPECT_NE(faults[0].find("no_such_relay"), std::string::npos);
  EXPECT_EQ(faults[2].find("no_such_lamp") == std::string::npos, false);
  EXPECT_TRUE(board::bring_outputs_to_safe_state(board::BoardFile()).empty());  // nothing to make safe
}

TEST_F(BoardFileTest, IioChannelsNameTheirElement) {
  std::string text = kGood;
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("source = \"can\"\nwiring = \"24\"", "source = \"iio\"\ndevice = \"ads8688\"\ntrigger = \"timer0\"");
  replace("name = \"force_1_N\"", "name = \"force_1_N\"\nelement = \"in_voltage3\"");
  replace("name = \"displacement_1_m\"", "name = \"displacement_1_m\"\nelement = \"in_voltage0\"");
  const board::BoardFile board = read(text);
  EXPECT_EQ(board.samples.kind, board::SampleKind::kIioBuffer);
  EXPECT_EQ(board.samples.device, "ads8688");
  EXPECT_EQ(board.samples.trigger, "timer0");
  ASSERT_EQ(board.samples.channels.size(), 2u);
  EXPECT_EQ(board.samples.channels[0].element, "in_voltage3");
  EXPECT_EQ(board.samples.channels[1].quantity, firmware::Quantity::kDisplacement);
}

// The bytes for a board without Linux are the same configuration.
TEST_F(BoardFileTest, BytesComeBackAsTheConfiguration) {
  const firmware::ControllerConfiguration expected = read(kGood).controller;
  FILE* output = ::popen((std::string(RIG_CONTROLLER) + " --bytes " + folder_ + "/board.toml").c_str(), "r");
  ASSERT_NE(output, nullptr);
  std::vector<uint8_t> bytes;
  for (unsigned value = 0; std::fscanf(output, " 0x%x,", &value) == 1;) bytes.push_back(static_cast<uint8_t>(value));
  EXPECT_EQ(::pclose(output), 0);
  firmware::ControllerConfiguration decoded;
  ASSERT_TRUE(firmware::decode(bytes.data(), bytes.size(), decoded));
  EXPECT_EQ(firmware::configuration_crc(decoded), firmware::configuration_crc(expected));
  EXPECT_EQ(decoded.node.node, 3);
  EXPECT_EQ(decoded.programme.levels[0].measure_samples, 60000u);
}

// A wire that breaks leaves the line where its bias pulls it.
TEST(BoardFile, CheckSaysWhereABrokenWireReadsAsReleased) {
  board::BoardFile board;
  board.emergency_stop.line = "stop";
  board.controller.programme.level_count = 1;
  board.samples.rate_Hz = 1000;
  for (const bool active_low : {false, true})
    for (const hal::LineBias bias :
         {hal::LineBias::kAsIs, hal::LineBias::kPullUp, hal::LineBias::kPullDown, hal::LineBias::kDisabled}) {
      board.emergency_stop.options = {active_low, bias};
      const bool stops = bias == (active_low ? hal::LineBias::kPullDown : hal::LineBias::kPullUp);
      EXPECT_EQ(board::describe(board).find("warning: emergency_stop") == std::string::npos, stops)
          << board::describe(board);
    }
}

TEST(RunMarker, WhatDidNotEndWellIsRememberedUntilARunThatDid) {
  char folder[] = "/tmp/run_marker_XXXXXX";
  ASSERT_NE(mkdtemp(folder), nullptr);
  board::RunMarker first, second, third, fourth;
  EXPECT_FALSE(first.begin(folder));  // and does not end well
  EXPECT_TRUE(second.begin(folder));
  EXPECT_TRUE(third.begin(folder));
  third.end_well();
  EXPECT_FALSE(fourth.begin(folder));
  fourth.end_well();
  std::filesystem::remove_all(folder);
}

TEST(RunMarker, AFolderThatTakesNoFileRemembersNothing) {
  board::RunMarker marker;
  EXPECT_FALSE(marker.begin("/nowhere/at/all"));
  EXPECT_FALSE(marker.begin(""));
  marker.end_well();
}

}  // namespace
