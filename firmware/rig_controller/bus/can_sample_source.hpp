// Samples from sensor frames on a CAN bus. It has a socket of its own, filtered to the sensors' identifiers, so that
// nothing else on the bus wakes it.
#pragma once
#include <cstddef>

#include "firmware/can_protocol/streams/sensor_frames.hpp"
#include "hal/interface/can_bus.hpp"
#include "hal/interface/sample_source.hpp"

namespace firmware {

class CanSampleSource final : public hal::SampleSource {
 public:
  CanSampleSource(hal::CanBus& bus, const SensorPlan& plan) : bus_(bus), assembler_(plan) {}

  // A bus that is down delivers no samples; that is no fault of the source: it goes on when the bus is back.
  hal::SampleResult read(RawSample& sample) override;
  uint32_t frames_lost() const override { return assembler_.health().lost_frames; }
  uint32_t overflows() const override { return bus_.receive_overflows(); }
  const AssemblyHealth& health() const { return assembler_.health(); }

 private:
  static constexpr int kFramesPerRead = 64;  // of other frames, before the caller gets its turn again
  hal::CanBus& bus_;
  SensorAssembler assembler_;
  hal::CanFrame frame_;  // the last one
};

// The identifiers that the plan's sensors send; returns their number, at most kMaxSensorFrames.
size_t sensor_ids(const SensorPlan& plan, uint32_t (&ids)[kMaxSensorFrames]);

}  // namespace firmware
