// A controller in the loop with a simulated rig; programmes and rigs that the tests share.
#pragma once
#include <cmath>
#include <memory>

#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/streams/estimate_frames.hpp"
#include "firmware/rig_controller/rig_controller.hpp"
#include "hal/fake/fake_can_bus.hpp"
#include "hal/fake/fake_configuration_store.hpp"
#include "tests/closed_loop/closed_loop_rig.hpp"

namespace closed_loop {

using firmware::ControllerMode;

constexpr double kRate_Hz = 1000.0;

inline rig_file::Coefficient known(double value) { return {value, false}; }

// Chain of masses, each linked to the next, the first and the last to ground.
inline rig_file::RigModel chain(const std::vector<double>& mass_kg, double stiffness,
                                const std::vector<double>& viscous, double coulomb) {
  rig_file::RigModel rig;
  rig.name = "chain";
  for (double mass : mass_kg) rig.dofs.push_back({false, known(mass), {}});
  const int n = static_cast<int>(mass_kg.size());
  for (int i = 0; i <= n; ++i) {
    rig_file::Link link;
    link.a = i == 0 ? 1 : i;
    link.b = i == 0 || i == n ? 0 : i + 1;
    link.stiffness_N_m = known(stiffness);
    link.viscous_N_s_m = known(viscous[static_cast<size_t>(i)]);
    if (i == 0) link.coulomb_N = known(coulomb);
    rig.links.push_back(link);
  }
  return rig;
}

// The same rig with its dampers and friction unknown.
inline rig_file::RigModel to_estimate(rig_file::RigModel rig) {
  for (rig_file::Link& link : rig.links) {
    link.viscous_N_s_m.estimate = true;
    if (link.coulomb_N.value != 0.0) link.coulomb_N.estimate = true;
  }
  return rig;
}

inline firmware::Drive part(double fraction) {
  return firmware::Drive::from_raw(static_cast<int32_t>(fraction * 2147483647.0));
}
inline uint32_t step_of(double frequency_Hz) {
  return static_cast<uint32_t>(std::lround(frequency_Hz / kRate_Hz * 4294967296.0));
}

inline firmware::ExcitationLevel sine_level(double fraction, double frequency_Hz, uint32_t cycle_samples) {
  firmware::ExcitationLevel level;
  level.amplitude = part(fraction);
  level.phase_step = step_of(frequency_Hz);
  level.ramp_samples = 200;
  level.settle.block_samples = 2 * cycle_samples;
  level.settle.bound_per_mille = 2;
  level.settle.blocks = 4;
  level.settle_limit_samples = 20000;
  level.measure_samples = 2000;
  return level;
}

struct Loop {
  Loop(const RigSettings& settings, const firmware::ExcitationProgramme& programme,
       firmware::WindowConfiguration window = {})
      : Loop(settings, settings.plant, programme, window) {}
  // The controller is told of another rig than the one that is there.
  Loop(const RigSettings& settings, const rig_file::RigModel& told, const firmware::ExcitationProgramme& programme,
       firmware::WindowConfiguration window = {})
      : rig(settings) {
    configuration.core = rig_file::compile_rig(to_estimate(told), settings.sample_period_s, rig.calibrations());
    configuration.core.window = window;
    configuration.programme = programme;
    configuration.programme.start_at_boot = true;
    const firmware::Ports ports{rig, rig, can, rig, rig.relay, lamp, stop_line, nullptr, watchdog, store};
    controller = std::make_unique<firmware::RigController>(configuration, ports);
  }
  void run_sample() {
    rig.advance();
    controller->step();
  }
  bool run_until(ControllerMode mode, int limit = 200000) {
    for (int i = 0; i < limit && controller->mode() != mode; ++i) run_sample();
    return controller->mode() == mode;
  }
  // From the last frame on the bus.
  firmware::EstimateRecord record(int index) {
    firmware::EstimateRecord found;
    const uint32_t id = firmware::can::frame_id(firmware::can::kEstimate.ids, 1, index);
    const hal::CanFrame* frame = can.last(id);
    if (frame == nullptr) return found;
    firmware::CanFrame message;
    message.id = frame->id;
    message.length = frame->length;
    for (int i = 0; i < frame->length; ++i) message.data[i] = frame->data[i];
    int node = 0, member = 0;
    unpack_estimate(message, node, member, found);
    return found;
  }
  static double number(const firmware::EstimateRecord& record) {
    return record.value * std::pow(10.0, record.exponent);
  }

  ClosedLoopRig rig;
  firmware::ControllerConfiguration configuration;
  hal::FakeCanBus can{rig};
  hal::FakeOutput lamp;
  hal::FakeInput stop_line;
  hal::FakeWatchdog watchdog;
  hal::FakeConfigurationStore store;
  std::unique_ptr<firmware::RigController> controller;
};

}  // namespace closed_loop
