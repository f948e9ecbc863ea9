#include "tests/rig_controller/bench.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bench {

using firmware::Scaled;

firmware::CoreConfiguration one_dof_core() {
  firmware::CoreConfiguration core;
  core.dof_count = 1;
  core.link_count = 1;
  core.links[0].node_a = 0;
  core.links[0].node_b = firmware::kGroundNode;
  core.term_count = 3;
  core.terms[0].kind = firmware::TermKind::kMass;
  core.terms[0].value = Scaled::from_int(1);
  core.terms[1].kind = firmware::TermKind::kStiffness;
  core.terms[1].value = Scaled::from_int(10000);
  core.terms[2].kind = firmware::TermKind::kViscous;
  core.terms[2].unknown = 0;
  core.unknown_count = 1;
  core.sample_period_s = Scaled::ratio(1, 1000);
  const Scaled units[] = {Scaled::ratio(1, 10000), Scaled::ratio(1, 100000000), Scaled::ratio(1, 1000000),
                          Scaled::ratio(1, 10000)};
  for (int quantity = 0; quantity < firmware::kQuantities; ++quantity) {
    core.channels[0][quantity].present = true;
    core.channels[0][quantity].unit_per_code = units[quantity];
  }
  firmware::copy_measured_signals(core);
  return core;
}

firmware::ExcitationProgramme two_levels() {
  firmware::ExcitationProgramme programme;
  programme.level_count = 2;
  programme.limits.magnitude = firmware::Drive::from_raw(1 << 30);
  for (int i = 0; i < 2; ++i) {
    auto& level = programme.levels[i];
    level.amplitude = firmware::Drive::from_raw(i == 0 ? 1 << 28 : 1 << 29);
    level.phase_step = 85899346;  // 2^32 / 50
    level.ramp_samples = 100;
    level.settle.block_samples = 50;
    level.settle_limit_samples = 5000;
    level.measure_samples = 1000;
  }
  return programme;
}

firmware::ControllerConfiguration listening() {
  firmware::ControllerConfiguration made;
  made.core = one_dof_core();
  return made;
}

firmware::ControllerConfiguration driving() {
  firmware::ControllerConfiguration made = listening();
  made.programme = two_levels();
  return made;
}

firmware::ControllerConfiguration driving_at_boot() {
  auto made = driving();
  made.programme.start_at_boot = true;
  return made;
}

void OneDofRig::advance(double force_N, double time_s) {
  force_N_ = force_N;
  constexpr int kSteps = 50;
  const double h = time_s / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    velocity_m_s_ += h * (force_N - 1e4 * position_m_ - 20.0 * velocity_m_s_);
    position_m_ += h * velocity_m_s_;
  }
}

firmware::RawSample OneDofRig::sample(uint32_t sequence) const {
  firmware::RawSample made;
  made.sequence = sequence;
  made.time_ns = sequence * kMillisecond_ns;
  made.code[0][0] = static_cast<int32_t>(std::lround(force_N_ / 1e-4));
  made.code[0][1] = static_cast<int32_t>(std::lround(position_m_ / 1e-8));
  made.code[0][2] = static_cast<int32_t>(std::lround(velocity_m_s_ / 1e-6));
  made.code[0][3] = static_cast<int32_t>(std::lround((force_N_ - 1e4 * position_m_ - 20.0 * velocity_m_s_) / 1e-4));
  return made;
}

Bench::Bench(const firmware::ControllerConfiguration& asked) : configuration(asked) {
  clock.set_ns(5 * kMillisecond_ns);
  restart();
}

void Bench::restart() {
  const firmware::Ports ports{clock,     source,     can,      drive, relay,  lamp,
                              stop_line, &sync_line, watchdog, store, worker, store_worker};
  controller = std::make_unique<firmware::RigController>(configuration, ports);
}

void Bench::run_sample() {
  clock.advance_ns(kMillisecond_ns);
  rig.advance(drive.drive_q31() / 2147483648.0 * kFullScaleForce_N, 1e-3);
  firmware::RawSample made = rig.sample(sequence++);
  made.time_ns = clock.now_ns() - late_ns;
  for (int quantity = 0; quantity < firmware::kQuantities; ++quantity)
    made.code[0][quantity] += spoil.code[0][quantity];
  source.offer(made);
  step();
}

void Bench::run_idle(int milliseconds) {
  for (int i = 0; i < milliseconds; ++i) {
    clock.advance_ns(kMillisecond_ns);
    step();
  }
}

bool Bench::run_until(firmware::ControllerMode mode, int limit) {
  for (int i = 0; i < limit; ++i) {
    if (controller->mode() == mode) return true;
    run_sample();
  }
  return controller->mode() == mode;
}

void Bench::drive_into(firmware::ControllerMode mode) {
  step();
  EXPECT_TRUE(controller->start());
  EXPECT_TRUE(run_until(mode));
  run_samples(20);
}

void Bench::network_command(uint8_t command, uint8_t node) {
  hal::CanFrame frame;
  frame.length = 2;
  frame.data[0] = command;
  frame.data[1] = node;
  can.inject(frame);
}

void Bench::sync() {
  hal::CanFrame frame;
  frame.id = 0x080;
  can.inject(frame);
}

Bench::Reply Bench::sdo(uint8_t command, uint16_t index, uint8_t subindex, uint32_t value) {
  hal::CanFrame frame;
  frame.id = 0x600u + configuration.node.node;
  frame.length = 8;
  frame.data[0] = command;
  frame.data[1] = static_cast<uint8_t>(index);
  frame.data[2] = static_cast<uint8_t>(index >> 8);
  frame.data[3] = subindex;
  for (int i = 0; i < 4; ++i) frame.data[4 + i] = static_cast<uint8_t>(value >> (8 * i));
  can.inject(frame);
  const uint32_t reply_id = 0x580u + configuration.node.node;
  const size_t before = can.count(reply_id);
  step();
  Reply reply;
  reply.came = can.count(reply_id) == before + 1;
  if (!reply.came) return reply;
  const hal::CanFrame& last = *can.last(reply_id);
  reply.command = last.data[0];
  for (int i = 0; i < 8; ++i) reply.data[i] = last.data[i];
  for (int i = 3; i >= 0; --i) reply.value = reply.value << 8 | last.data[4 + i];
  return reply;
}

}  // namespace bench
