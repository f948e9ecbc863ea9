#include "firmware/rig_controller/levels/measurement.hpp"

namespace firmware {
namespace {

constexpr uint64_t kJudgement_ns = 1000000000;

}  // namespace

// A worker that does not come back takes the estimates with it: the drive stops, and the watchdog restarts the board.
Alarm Measurement::worker_alarm() {
  const bool was_late = worker_late_;
  worker_late_ = estimation_.late();
  if (!worker_late_ || was_late) return Alarm{};
  return {AlarmCause::kWorkerLate, static_cast<uint32_t>(Estimation::kLongestWork_ns / 1000000)};
}

Alarm Measurement::loss_alarm() {
  const uint32_t dropped = estimation_.dropped_samples() - told_dropped_;
  told_dropped_ += dropped;
  return dropped == 0 ? Alarm{} : Alarm{AlarmCause::kSamplesMissed, dropped};
}

// The core's own count is the worker's while it works.
bool Measurement::has_room() {
  if (estimation_.idle()) levels_ = estimation_.core().table().level_count;
  return levels_ < kMaxLevels;
}

void Measurement::begin_level() {
  ++levels_;
  estimation_.begin_level();
  running_ = true;
  clock_.begin_level();
  samples_in_window_ = 0;
  window_samples_ = configuration_.node.window_samples;
}

void Measurement::end_level() {
  if (!running_) return;
  cut_level();
  close_window();
}

void Measurement::cut_level() {
  if (running_) estimation_.end_level();
  running_ = false;
}

void Measurement::close_begun_window() {
  if (running_ && samples_in_window_ > 0) close_window();
}

void Measurement::close_window() {
  samples_in_window_ = 0;
  const bool judge = estimation_.now_ns() >= next_judgement_ns_ || !running_;
  if (judge) next_judgement_ns_ = estimation_.now_ns() + kJudgement_ns;
  estimation_.solve(judge, clock_.off_rate(configuration_.core.sample_period_s));
}

}  // namespace firmware
