#include "host_sim/virtual_rig/level_feed.hpp"

#include <algorithm>

namespace host_sim {
namespace {

constexpr uint64_t kHeartbeat_ns = 100000000;

}  // namespace

void LevelFeed::run() {
  firmware::RawSample sample;
  board_.run_at(0);
  while (rig_.read(sample) == hal::SampleResult::kSample) {
    ++read_;
    if (rig_.first_of_level()) begin_level();
    take(sample);
    if (rig_.last_of_level()) {
      board_.end_level();
      tell_window();
    }
  }
  board_.finish(rig_.now_ns());
  board_.run_at(rig_.now_ns() + kHeartbeat_ns);
}

void LevelFeed::begin_level() {
  const ExcitationLevel& level = rig_.scenario().levels[rig_.level()];
  const size_t margin = static_cast<size_t>(board_.core().margin_samples());
  first_ = level.settle_samples - std::min(margin, level.settle_samples);
  end_ = first_ + level.samples + margin;
}

bool LevelFeed::wanted() const { return rig_.sample_of_level() >= first_ && rig_.sample_of_level() < end_; }

// Settling and run-out pass by with the controller running, but unseen by it: it is not started yet, or stopped again.
void LevelFeed::take(firmware::RawSample& sample) {
  if (!wanted()) return board_.run_at(rig_.now_ns());
  if (rig_.sample_of_level() == first_) board_.begin_level();
  sample.sequence = static_cast<uint32_t>(pushed_++);  // what is left out between levels is not missed
  if (!board_.push(sample, rig_.now_ns())) return;
  tell_window();
  sink_.progress(static_cast<double>(read_) / static_cast<double>(rig_.total_samples()));
}

void LevelFeed::tell_window() const {
  sink_.window(rig_.now_ns(), *board_.controller().estimates(), board_.core().health(), false);
}

}  // namespace host_sim
