// scenario_script SCENARIO SEED FILE [SAMPLES [x]]: what the board would sample in a shipped scenario, as a script (script.hpp); the
// estimates are asked for once a second and at each level's end. SAMPLES: of each level, the first ones.
// x: force and displacement are measured alone.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>

#include "firmware/rig_controller/settings/controller_configuration.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/first_batches.hpp"
#include "host_sim/virtual_rig/board_configuration.hpp"
#include "host_sim/virtual_rig/run_scenario.hpp"
#include "host_sim/virtual_rig/virtual_rig.hpp"

namespace {

void put32(std::ofstream& out, uint32_t value) {
  for (int i = 0; i < 4; ++i) out.put(static_cast<char>(value >> (8 * i)));
}

// As of a scenario whose levels are that short.
firmware::WindowConfiguration window_of(const host_sim::Scenario& scenario, size_t most) {
  firmware::WindowConfiguration window = host_sim::scenario_window(scenario);
  for (const host_sim::ExcitationLevel& level : scenario.levels)
    if (window.batch_samples != 0)
      window.batch_samples =
          std::min(window.batch_samples, rig_file::first_batch_samples(std::min(level.samples, most)));
  return window;
}

void write(const host_sim::Scenario& scenario, uint64_t seed, const std::string& path, size_t most) {
  host_sim::VirtualRig rig(scenario, seed);
  firmware::CoreConfiguration core =
      rig_file::compile_rig(scenario.rig, scenario.sample_period_s(), rig.measured().calibrations);
  core.window = window_of(scenario, most);
  const firmware::ControllerConfiguration configuration =
      host_sim::board_configuration(scenario.rig, core, scenario.sample_period_s());
  static uint8_t bytes[firmware::kConfigurationBytes];
  const size_t length = firmware::encode(configuration, bytes);
  std::ofstream out(path, std::ios::binary);
  out << "RIG1";
  put32(out, static_cast<uint32_t>(length));
  out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(length));
  const size_t second = static_cast<size_t>(std::lround(scenario.sample_rate_Hz));
  firmware::RawSample sample;
  size_t in_level = 0;
  while (rig.read(sample) == hal::SampleResult::kSample) {
    if (rig.first_of_level()) {
      out.put('L');
      in_level = 0;
    }
    if (rig.phase() != host_sim::RigPhase::kSettling && in_level < most) {
      out.put('S');
      for (int node = 0; node < firmware::kMaxNodes; ++node)
        for (int quantity = 0; quantity < firmware::kQuantities; ++quantity)
          if (core.channels[node][quantity].present) put32(out, static_cast<uint32_t>(sample.code[node][quantity]));
      if (++in_level % second == 0) out.put('W');
    }
    if (rig.last_of_level()) out << "EW";
  }
  out << 'Q';
}

}  // namespace

int main(int count, char** words) {
  if (count < 4 || count > 6) {
    std::cerr << "usage: scenario_script SCENARIO SEED FILE [SAMPLES [x]]\n";
    return 2;
  }
  try {
    host_sim::Scenario scenario = host_sim::load_scenario(words[1]);
    if (count == 6) scenario.sensors.quantities = {host_sim::Quantity::kForce, host_sim::Quantity::kDisplacement};
    write(scenario, std::stoull(words[2]), words[3], count >= 5 ? std::stoull(words[4]) : SIZE_MAX);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "scenario_script: " << error.what() << "\n";
    return 1;
  }
}
