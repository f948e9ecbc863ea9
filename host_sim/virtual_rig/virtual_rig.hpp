// The simulated rig as the board sees it: converter codes one sample after the other, and the clock that they set.
#pragma once
#include <memory>
#include <utility>

#include "hal/interface/clock.hpp"
#include "hal/interface/sample_source.hpp"
#include "host_sim/plant/instruments/sensors.hpp"
#include "host_sim/records/digitise.hpp"

namespace host_sim {

enum class RigPhase {
  kWaiting,  // before the first sample
  kSettling,
  kMeasuring,  // the level's samples sample periods, both ends included
  kRunOut,     // run_out_samples beyond
  kDone,
};

// Yields all levels of a scenario in order. Simulated time goes forward by one sample period per read() and never by
// itself.
class VirtualRig : public hal::SampleSource, public hal::MonotonicClock {
 public:
  // Simulates everything at once: noise in percent of a channel's rms is only known then. Throws PlantError.
  VirtualRig(const Scenario& scenario, uint64_t seed);

  hal::SampleResult read(firmware::RawSample& sample) override;  // sequence counts on over levels
  uint64_t now_ns() override { return time_ns_; }                // of the last sample read

  // Of the last sample read.
  size_t level() const { return level_; }
  RigPhase phase() const { return phase_; }
  size_t sample_of_level() const { return next_in_level_ - 1; }  // counted from the first of settling
  bool first_of_level() const { return next_in_level_ == 1; }
  bool last_of_level() const;

  size_t total_samples() const { return total_; }
  const Scenario& scenario() const { return scenario_; }
  const MeasuredLevels& measured() const { return measured_; }
  MeasuredLevels take_measured() { return std::move(measured_); }  // nothing can be read any more

 private:
  void open_level();

  Scenario scenario_;
  MeasuredLevels measured_;
  std::unique_ptr<RecordSampleSource> source_;
  size_t level_ = 0, next_in_level_ = 0, total_ = 0;
  uint64_t read_ = 0, time_ns_ = 0;
  RigPhase phase_ = RigPhase::kWaiting;
};

}  // namespace host_sim
