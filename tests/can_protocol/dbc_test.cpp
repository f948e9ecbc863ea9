// The DBC by a reader of its own: complete, well-formed, and with the numbers that the firmware packed.
#include "host_sim/can_log/dbc.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/streams/estimate_frames.hpp"
#include "firmware/can_protocol/streams/sensor_frames.hpp"
#include "tests/can_protocol/dbc_reader.hpp"

namespace {

using firmware::CanFrame;

const std::string& dbc_text() {
  static const std::string text = [] {
    std::ostringstream output;
    can_log::dbc(output);
    return output.str();
  }();
  return text;
}

dbc_reader::Dbc& read_dbc() {
  static dbc_reader::Dbc dbc = [] {
    std::istringstream input(dbc_text());
    return dbc_reader::read(input);
  }();
  return dbc;
}

TEST(Dbc, HasNeitherMultiplexingNorFloatsNorBigEndian) {
  EXPECT_EQ(dbc_text().rfind("VERSION", 0), 0u);
  EXPECT_EQ(dbc_text().find(" m0 "), std::string::npos);
  EXPECT_EQ(dbc_text().find(" M "), std::string::npos);
  EXPECT_EQ(dbc_text().find("SIG_VALTYPE_"), std::string::npos);
  EXPECT_EQ(dbc_text().find("@0"), std::string::npos);
  EXPECT_NE(dbc_text().find("\nVAL_ "), std::string::npos);
}

TEST(Dbc, IsWellFormed) {
  dbc_reader::Dbc& dbc = read_dbc();
  for (const std::string& fault : dbc.faults) ADD_FAILURE() << fault;
  std::set<std::string> names;
  const std::set<std::string> nodes(dbc.nodes.begin(), dbc.nodes.end());
  for (auto& [id, message] : dbc.messages) {
    EXPECT_TRUE(names.insert(message.name).second) << message.name;
    EXPECT_LE(message.name.size(), 32u) << message.name;
    EXPECT_EQ(nodes.count(message.sender), 1u) << message.sender;
    EXPECT_FALSE(message.comment.empty()) << message.name;
    EXPECT_GE(message.cycle_ms, 0) << message.name;
    EXPECT_EQ(message.fd, message.length > 8) << message.name;
    std::set<int> bits;
    for (const dbc_reader::Signal& signal : message.signals) {
      const std::string where = message.name + "." + signal.name;
      EXPECT_TRUE(signal.little_endian) << where;
      EXPECT_LE(signal.name.size(), 32u) << where;
      EXPECT_FALSE(signal.unit.empty()) << where;
      EXPECT_FALSE(signal.comment.empty()) << where;
      EXPECT_LT(signal.minimum, signal.maximum) << where;
      EXPECT_LE(signal.start + signal.length, message.length * 8) << where;
      for (int bit = signal.start; bit < signal.start + signal.length; ++bit)
        EXPECT_TRUE(bits.insert(bit).second) << where << " bit " << bit;
      for (const auto& [value, name] : signal.values) EXPECT_LT(value, int64_t{1} << signal.length) << where << name;
      EXPECT_EQ(signal.values.empty(), signal.unit != "state" && signal.unit != "flag" && signal.unit != "DOF")
          << where;
    }
  }
}

TEST(Dbc, ListsEveryFrameThatIsSent) {
  dbc_reader::Dbc& dbc = read_dbc();
  size_t count = 0;
  for (const firmware::can::FrameDescription* frame : firmware::can::kFrames) {
    const bool per_node = frame->ids.node_stride > 0;
    for (int node = per_node ? 1 : 0; node <= (per_node ? 7 : 0); ++node)
      for (int member = 0; member < frame->ids.members; ++member, ++count) {
        const CanFrame message = firmware::can::empty_frame(*frame, node, member);
        ASSERT_EQ(dbc.messages.count(message.id), 1u) << message.id;
        EXPECT_EQ(dbc.messages[message.id].length, message.length);
        EXPECT_EQ(dbc.messages[message.id].fd, message.fd);
      }
  }
  EXPECT_EQ(dbc.messages.size(), count);
}

double value_of(const CanFrame& message, const std::string& signal) {
  dbc_reader::Signal* found = read_dbc().messages[message.id].find(signal);
  if (found == nullptr) {
    ADD_FAILURE() << "no signal " << signal;
    return 0;
  }
  return dbc_reader::physical(*found, message.data);
}

std::string state_of(const CanFrame& message, const std::string& signal) {
  dbc_reader::Signal* found = read_dbc().messages[message.id].find(signal);
  return found == nullptr ? "no signal" : found->values[dbc_reader::raw_value(*found, message.data)];
}

TEST(Dbc, GivesTheNumbersThatWerePacked) {
  // viscous 20.0012 +- 0.0123: value * 10^exponent and std * 10^(exponent + std_exponent).
  firmware::ParameterEstimate estimate;
  estimate.value = firmware::Scaled::ratio(-200012, 10000);
  estimate.std = firmware::Scaled::ratio(123, 10000);
  estimate.status = firmware::EstimateStatus::kSkewed;
  const CanFrame e = firmware::pack_estimate(3, 20, estimate, 21);
  EXPECT_EQ(read_dbc().messages[e.id].name, "estimate_3_20");
  EXPECT_EQ(value_of(e, "value"), -2000120000.0);
  EXPECT_EQ(value_of(e, "exponent"), -8.0);
  EXPECT_EQ(value_of(e, "std"), 12300.0);
  EXPECT_EQ(value_of(e, "std_exponent"), 2.0);
  EXPECT_EQ(value_of(e, "window"), 5.0);
  EXPECT_EQ(state_of(e, "status"), "SKEWED");

  firmware::Estimates estimates;
  estimates.unknown_count = 10;
  estimates.parameters[9] = estimate;
  const CanFrame fd = firmware::pack_estimates_fd(3, 1, estimates);  // indices 8 to 15: 9 is record 1
  EXPECT_EQ(value_of(fd, "value_1"), -2000120000.0);
  EXPECT_EQ(state_of(fd, "status_1"), "SKEWED");
  EXPECT_EQ(state_of(fd, "status_2"), "STALE");
  EXPECT_EQ(value_of(fd, "value_2"), -2147483648.0);  // unused

  const CanFrame drive = firmware::pack_drive(1, {-(1 << 30), 0, firmware::DriveState::kEnabled});
  EXPECT_EQ(value_of(drive, "drive"), -50.0);  // half of full scale

  firmware::NodeStatus status;
  status.faults = firmware::fault_bit(firmware::Fault::kWatchdog);
  status.mode = firmware::ControllerMode::kSettle;
  const CanFrame s = firmware::pack_status(7, status);
  EXPECT_EQ(state_of(s, "mode"), "SETTLE");
  EXPECT_EQ(state_of(s, "faults_watchdog"), "WATCHDOG");
  EXPECT_EQ(state_of(s, "faults_emergency_stop"), "no");

  firmware::Diagnosis diagnosis;
  diagnosis.unexplained_permille = 123;
  const CanFrame d = firmware::pack_diagnosis(1, diagnosis);
  EXPECT_DOUBLE_EQ(value_of(d, "unexplained"), 12.3);
  EXPECT_EQ(state_of(d, "place_b"), "NONE");
  EXPECT_NEAR(value_of(firmware::pack_window(1, {1110000, 96, 3}), "residual"), 1.11e-3, 1e-15);

  firmware::CoreConfiguration configuration;
  for (auto& channel : configuration.channels[firmware::kBaseNode]) channel.present = true;
  firmware::RawSample sample;
  sample.sequence = 70000;
  sample.code[firmware::kBaseNode][0] = -8388608;
  sample.code[firmware::kBaseNode][2] = 4660;
  CanFrame frames[firmware::kMaxSensorFrames];
  for (firmware::SensorWiring wiring : {firmware::SensorWiring::k24, firmware::SensorWiring::kFd}) {
    const int count = firmware::pack_sample(firmware::sensor_plan(configuration, wiring), sample, frames);
    EXPECT_EQ(value_of(frames[count - 1], "force"), -8388608.0);
    EXPECT_EQ(value_of(frames[0], "velocity"), 4660.0);
    EXPECT_EQ(value_of(frames[0], "sequence"), frames[0].fd ? 70000.0 : 70000.0 - 65536.0);
    EXPECT_EQ(read_dbc().messages[frames[0].id].name, frames[0].fd ? "sensor_fd_base" : "sensor_motion_24_base");
  }
}

TEST(Dbc, OfARigNamesItsParametersInTheComments) {
  std::ostringstream output;
  can_log::dbc(output, {{"viscous[1-0]", "N s/m"}, {"viscous[1-2]", "N s/m"}, {"coulomb[3-0]", "N"}});
  std::istringstream input(output.str());
  dbc_reader::Dbc dbc = dbc_reader::read(input);
  EXPECT_EQ(dbc.messages[0x411].comment.rfind("viscous[1-2]. ", 0), 0u) << dbc.messages[0x411].comment;
  EXPECT_EQ(dbc.messages.count(0x413), 0u);  // no fourth parameter
  EXPECT_NE(dbc.messages[0x2C8].comment.find("coulomb[3-0]"), std::string::npos);
  EXPECT_EQ(dbc.messages.count(0x2C9), 0u);
}

TEST(Dbc, OfARigHasItsEstimatesAsFloatsInSiUnits) {
  std::ostringstream output;
  can_log::dbc(output, {{"viscous[1-0]", "N s/m"}, {"displacement_dependent_damping[12-base]", "N s/m^3"}});
  std::istringstream input(output.str());
  dbc_reader::Dbc dbc = dbc_reader::read(input);
  for (const std::string& fault : dbc.faults) ADD_FAILURE() << fault;
  EXPECT_EQ(dbc.messages.count(0x592), 0u);  // no third parameter
  dbc_reader::Message& message = dbc.messages[0x590];
  EXPECT_EQ(message.name, "estimate_float_1_0");
  dbc_reader::Signal* value = message.find("viscous_1_0");
  dbc_reader::Signal* std = message.find("viscous_1_0_std");
  ASSERT_TRUE(value != nullptr && std != nullptr);
  EXPECT_TRUE(value->is_float && std->is_float && value->is_signed);
  EXPECT_EQ(value->unit, "N s/m");
  EXPECT_EQ(value->factor, 1.0);
  EXPECT_EQ(value->comment, "viscous[1-0]");
  // The words of a long kind are cut to four letters: 32 characters is the longest name that every tool reads.
  ASSERT_NE(dbc.messages[0x591].find("disp_depe_damp_12_base_std"), nullptr);
  for (const auto& entry : dbc.messages)
    for (const dbc_reader::Signal& signal : entry.second.signals) EXPECT_LE(signal.name.size(), 32u) << signal.name;

  firmware::ParameterEstimate estimate;
  estimate.value = firmware::Scaled::ratio(-200012, 10000);
  estimate.std = firmware::Scaled::ratio(123, 10000);
  estimate.status = firmware::EstimateStatus::kValid;
  const CanFrame packed = firmware::pack_estimate_float(1, 0, estimate);
  EXPECT_EQ(dbc_reader::float_value(*value, packed.data), static_cast<double>(-20.0012f));
  EXPECT_EQ(dbc_reader::float_value(*std, packed.data), static_cast<double>(0.0123f));

  // CAN FD: both parameters in the first frame, and nothing else.
  EXPECT_EQ(dbc.messages[0x338].signals.size(), 4u);
  EXPECT_EQ(dbc.messages[0x338].signals[3].name, "disp_depe_damp_12_base_std");
  EXPECT_EQ(dbc.messages[0x338].signals[3].start, 96);
}

}  // namespace
