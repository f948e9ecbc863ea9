#include "firmware/rig_controller/bus/can_sample_source.hpp"

namespace firmware {

hal::SampleResult CanSampleSource::read(RawSample& sample) {
  for (int i = 0; i < kFramesPerRead && bus_.receive(frame_) == hal::CanResult::kDone; ++i) {
    if (frame_.error || frame_.remote) continue;
    if (assembler_.push(frame_, frame_.time_ns, sample)) return hal::SampleResult::kSample;
  }
  return hal::SampleResult::kNone;
}

size_t sensor_ids(const SensorPlan& plan, uint32_t (&ids)[kMaxSensorFrames]) {
  CanFrame messages[kMaxSensorFrames];
  const int count = pack_sample(plan, RawSample(), messages);
  for (int i = 0; i < count; ++i) ids[i] = messages[i].id;
  return static_cast<size_t>(count);
}

}  // namespace firmware
