// Records the sensor frames of a simulated scenario: a candump log for canplayer, and the board file that goes with it.
// usage: record_sensors SCENARIO SETTLE_S MEASURE_S LOG BOARD_HEAD BOARD.toml
// Of every level, MEASURE_S after SETTLE_S are recorded. Between two levels the sequence jumps by 5000 samples, as it
// does when a rig is measured twice. BOARD_HEAD is a board file without its [[channel]] tables, which are added.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>

#include "firmware/can_protocol/streams/sensor_frames.hpp"
#include "hal/rig_file/channel_name.hpp"
#include "host_sim/can_log/log_writer.hpp"
#include "host_sim/virtual_rig/virtual_rig.hpp"

namespace {

std::string channel_tables(const host_sim::VirtualRig& rig) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  for (const rig_file::ChannelCalibration& channel : rig.measured().calibrations)
    text << "\n[[channel]]\nname = \"" << rig_file::format_channel_name({channel.quantity, channel.dof, false})
         << "\"\nunit_per_code = " << std::scientific << channel.unit_per_code
         << "\noffset_code = " << channel.offset_code << "\nfull_scale_code = " << channel.highest_code << "\n";
  return text.str();
}

void record(host_sim::VirtualRig& rig, std::ostream& output) {
  const firmware::CoreConfiguration configuration =
      rig_file::compile_rig(rig.scenario().rig, rig.scenario().sample_period_s(), rig.measured().calibrations);
  const firmware::SensorPlan plan = firmware::sensor_plan(configuration, firmware::SensorWiring::k24);
  can_log::LogWriter log(output, "vcan0", can_log::kSimulatedEpoch_s);
  firmware::RawSample sample;
  firmware::CanFrame messages[firmware::kMaxSensorFrames];
  uint32_t written = 0;
  while (rig.read(sample) == hal::SampleResult::kSample) {
    if (rig.phase() != host_sim::RigPhase::kMeasuring) continue;
    sample.sequence = written + 5000 * static_cast<uint32_t>(rig.level());
    const int count = firmware::pack_sample(plan, sample, messages);
    for (int i = 0; i < count; ++i)
      log.write(messages[i], uint64_t{1000000} * written + 20000 * static_cast<uint64_t>(i));
    ++written;
  }
  std::fprintf(stderr, "%u samples\n", written);
}

}  // namespace

int main(int count, char** words) {
  if (count != 7) return 2;
  try {
    host_sim::Scenario scenario = host_sim::load_scenario(words[1]);
    for (host_sim::ExcitationLevel& level : scenario.levels) {
      level.settle_samples = static_cast<size_t>(std::lround(std::stod(words[2]) * scenario.sample_rate_Hz));
      level.samples = static_cast<size_t>(std::lround(std::stod(words[3]) * scenario.sample_rate_Hz));
    }
    host_sim::VirtualRig rig(scenario, 1);
    std::ofstream log(words[4]);
    record(rig, log);
    std::ofstream(words[6]) << std::ifstream(words[5]).rdbuf() << channel_tables(rig);
    return log.good() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
