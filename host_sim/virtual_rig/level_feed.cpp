#include "host_sim/virtual_rig/level_feed.hpp"

#include <algorithm>

namespace host_sim {
namespace {

constexpr uint64_t kTick_ns = 100000000, kWindow_ns = 1000000000;

}  // namespace

void LevelFeed::run() {
  firmware::RawSample sample;
  uint64_t last_ns = 0;
  while (rig_.read(sample) == hal::SampleResult::kSample) {
    ++read_;
    if (rig_.first_of_level()) begin_level();
    if (wanted()) push(sample);
    const uint64_t now_ns = rig_.now_ns();
    if (now_ns / kTick_ns != last_ns / kTick_ns) tell(now_ns, now_ns / kWindow_ns != last_ns / kWindow_ns);
    last_ns = now_ns;
    if (rig_.last_of_level()) {
      core_.end_level();
      sink_.window(now_ns, core_.solve(), core_.health(), false);
    }
  }
}

void LevelFeed::begin_level() {
  core_.begin_level();
  const ExcitationLevel& level = rig_.scenario().levels[rig_.level()];
  const size_t margin = static_cast<size_t>(core_.margin_samples());
  first_ = level.settle_samples - std::min(margin, level.settle_samples);
  end_ = first_ + level.samples + margin;
}

bool LevelFeed::wanted() const { return rig_.sample_of_level() >= first_ && rig_.sample_of_level() < end_; }

void LevelFeed::push(firmware::RawSample& sample) {
  sample.sequence = static_cast<uint32_t>(pushed_++);  // what is left out between levels is not missed
  core_.push(sample);
}

void LevelFeed::tell(uint64_t now_ns, bool window) {
  sink_.tick(now_ns);
  sink_.progress(static_cast<double>(read_) / static_cast<double>(rig_.total_samples()));
  if (window && rig_.phase() != RigPhase::kSettling && wanted())
    sink_.window(now_ns, core_.solve(), core_.health(), false);
}

}  // namespace host_sim
