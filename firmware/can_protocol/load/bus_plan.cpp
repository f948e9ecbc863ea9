#include "firmware/can_protocol/load/bus_plan.hpp"

#include <initializer_list>

#include "firmware/can_protocol/frame_table.hpp"
#include "firmware/can_protocol/load/bus_load.hpp"

namespace firmware {
namespace {

constexpr int64_t kMillisecond_ns = 1000000, kSecond_ns = 1000 * kMillisecond_ns;

void add(BusPlan& plan, const can::FrameDescription& frame, int frames, int64_t period_ns) {
  if (frames > 0 && period_ns > 0 && plan.count < kMaxBusStreams)
    plan.streams[plan.count++] = {&frame, frames, period_ns};
}

void add_sensors(BusPlan& plan, const SensorPlan& sensors, int64_t period_ns) {
  for (const SensorWiring wiring : {SensorWiring::k16, SensorWiring::k24, SensorWiring::kFd, SensorWiring::kPairs}) {
    int motion = 0, force = 0;
    for (int node = 0; node < kMaxNodes; ++node) {
      if (sensors.wiring[node] != wiring) continue;
      motion += sensors.expected[node] & 1;
      force += sensors.expected[node] >> 1 & 1;
    }
    const can::FrameDescription& motion_frame = wiring == SensorWiring::kFd      ? can::kSensorFd
                                                : wiring == SensorWiring::kPairs ? can::kSensorPair24
                                                : wiring == SensorWiring::k24    ? can::kSensorMotion24
                                                                                 : can::kSensorMotion16;
    add(plan, motion_frame, motion, period_ns);
    add(plan, wiring == SensorWiring::k24 ? can::kSensorForce24 : can::kSensorForce, force, period_ns);
  }
}

int64_t load_per_million(const BusStream& stream, const BitRates& rates) {
  const int64_t time_ns = stream.frames * can::frame_time_ns(*stream.frame, rates.nominal, rates.data);
  return (1000000 * time_ns + stream.period_ns - 1) / stream.period_ns;
}

}  // namespace

BusPlan bus_plan(const BusTraffic& traffic) {
  BusPlan plan;
  if (traffic.sensors != nullptr) add_sensors(plan, *traffic.sensors, traffic.sample_period_ns);
  add(plan, can::kDrive, traffic.drive_on_can ? 1 : 0, traffic.sample_period_ns);
  add(plan, can::kWindow, 1, traffic.window_ns);
  const int records = can::kEstimateFd.repeats;
  const int estimates = traffic.can_fd ? (traffic.unknowns + records - 1) / records : traffic.unknowns;
  add(plan, traffic.can_fd ? can::kEstimateFd : can::kEstimate, estimates, traffic.window_ns);
  if (traffic.float_estimates)
    add(plan, traffic.can_fd ? can::kEstimateFloatFd : can::kEstimateFloat, estimates, traffic.window_ns);
  add(plan, can::kHeartbeat, 1, traffic.heartbeat_ms * kMillisecond_ns);
  add(plan, can::kStatus, 1, traffic.status_ms * kMillisecond_ns);
  for (const can::FrameDescription* frame : {&can::kHealth, &can::kBusHealth, &can::kIdentity, &can::kDiagnosis,
                                             &can::kDiagnosisSize, &can::kDiagnosisRival})
    add(plan, *frame, 1, kSecond_ns);
  add(plan, can::kParameter, traffic.unknowns, kSecond_ns);
  for (const can::FrameDescription* frame : {&can::kScaling, &can::kRange})
    add(plan, *frame, traffic.channels, frame->cycle_ms * kMillisecond_ns);
  return plan;
}

int64_t load_permille(const BusStream& stream, const BitRates& rates) {
  return (load_per_million(stream, rates) + 999) / 1000;
}

int64_t load_permille(const BusPlan& plan, const BitRates& rates) {
  int64_t sum = 0;
  for (int i = 0; i < plan.count; ++i) sum += load_per_million(plan.streams[i], rates);
  return (sum + 999) / 1000;
}

}  // namespace firmware
