#include "host_sim/virtual_rig/virtual_rig.hpp"

#include <cmath>

namespace host_sim {

VirtualRig::VirtualRig(const Scenario& scenario, uint64_t seed)
    : scenario_(scenario), measured_(measure(scenario, seed)) {
  for (const ExcitationLevel& level : scenario_.levels) total_ += level.recorded();
  open_level();
}

void VirtualRig::open_level() {
  source_ = std::make_unique<RecordSampleSource>(measured_.measured[level_], measured_.calibrations);
  next_in_level_ = 0;
}

bool VirtualRig::last_of_level() const { return next_in_level_ == scenario_.levels[level_].recorded(); }

hal::SampleResult VirtualRig::read(firmware::RawSample& sample) {
  if (phase_ == RigPhase::kDone) return hal::SampleResult::kEnd;
  if (last_of_level()) {
    if (level_ + 1 == scenario_.levels.size()) {
      phase_ = RigPhase::kDone;
      return hal::SampleResult::kEnd;
    }
    ++level_;
    open_level();
  }
  if (source_->read(sample) != hal::SampleResult::kSample) return hal::SampleResult::kFault;
  time_ns_ = static_cast<uint64_t>(std::llround(static_cast<double>(read_) * scenario_.sample_period_s() * 1e9));
  sample.sequence = static_cast<uint32_t>(read_++);
  sample.time_ns = time_ns_;
  const ExcitationLevel& level = scenario_.levels[level_];
  const size_t k = next_in_level_++;
  phase_ = k < level.settle_samples                    ? RigPhase::kSettling
           : k <= level.settle_samples + level.samples ? RigPhase::kMeasuring
                                                       : RigPhase::kRunOut;
  return hal::SampleResult::kSample;
}

}  // namespace host_sim
