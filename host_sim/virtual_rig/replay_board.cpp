#include "host_sim/virtual_rig/replay_board.hpp"

namespace host_sim {

firmware::ControllerConfiguration ReplayBoard::commanded(firmware::ControllerConfiguration configuration) {
  configuration.programme.level_count = 0;
  configuration.node.listen_on_command = true;
  return configuration;
}

hal::CanResult ReplayBoard::FrameBus::send(const hal::CanFrame& frame) {
  hal::CanFrame stamped = frame;
  stamped.time_ns = clock_.now_ns();
  take_(stamped);
  return hal::CanResult::kDone;
}

ReplayBoard::ReplayBoard(const firmware::ControllerConfiguration& configuration, Take take)
    : bus_(clock_, std::move(take)),
      controller_(std::make_unique<firmware::RigController>(
          commanded(configuration),
          firmware::Ports{clock_, source_, bus_, drive_, relay_, lamp_, stop_line_, nullptr, watchdog_, store_})) {}

void ReplayBoard::run_at(uint64_t time_ns) {
  clock_.set_ns(time_ns);
  controller_->step();
}

void ReplayBoard::begin_level() { controller_->start(); }

bool ReplayBoard::push(const firmware::RawSample& sample, uint64_t time_ns) {
  const firmware::Estimates* before = controller_->estimates();
  const uint32_t windows = before != nullptr ? before->window_counter : 0;
  source_.offer(sample);
  run_at(time_ns);
  const firmware::Estimates* after = controller_->estimates();
  return after != nullptr && after->window_counter != windows;
}

void ReplayBoard::end_level() { controller_->stop(); }

void ReplayBoard::finish(uint64_t time_ns) {
  source_.fail(hal::SampleFailure::kEnded);
  run_at(time_ns);
}

}  // namespace host_sim
