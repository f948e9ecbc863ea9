#include "hal/linux/can_sample_source.hpp"

#include <algorithm>
#include <cstring>

namespace hal {

SampleResult CanSampleSource::read(firmware::RawSample& sample) {
  CanFrame frame;
  for (int i = 0; i < kFramesPerRead && bus_.receive(frame) == CanResult::kDone; ++i) {
    if (frame.error || frame.remote) continue;
    firmware::CanMessage message;
    message.id = frame.id;
    message.extended = frame.extended;
    message.fd = frame.fd;
    message.length = frame.length;
    std::memcpy(message.data, frame.data, sizeof message.data);
    if (assembler_.push(message, frame.time_ns, sample)) return SampleResult::kSample;
  }
  return SampleResult::kNone;
}

size_t sensor_ids(const firmware::SensorPlan& plan, uint32_t (&ids)[firmware::kMaxSensorFrames]) {
  firmware::CanMessage messages[firmware::kMaxSensorFrames];
  const int count = firmware::pack_sample(plan, firmware::RawSample(), messages);
  for (int i = 0; i < count; ++i) ids[i] = messages[i].id;
  return static_cast<size_t>(count);
}

}  // namespace hal
