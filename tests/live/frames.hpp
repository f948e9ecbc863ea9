// Frames as a controller would send them, with a time.
#pragma once
#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/streams/estimate_frames.hpp"
#include "host_sim/can_log/candump_line.hpp"

namespace frames {

inline can_log::LogEntry at(double time_s, const firmware::CanFrame& message) {
  can_log::LogEntry entry;
  entry.has_time = true;
  entry.interface = "can0";
  entry.frame = can_log::to_frame(message, static_cast<uint64_t>(time_s * 1e9 + 0.5));
  return entry;
}

inline can_log::LogEntry error_at(double time_s, uint32_t classes) {
  can_log::LogEntry entry = at(time_s, firmware::CanFrame{});
  entry.frame.error = true;
  entry.frame.id = classes;
  entry.frame.length = 8;
  return entry;
}

inline firmware::CanFrame heartbeat(int node = 1) {
  return firmware::pack_heartbeat(node, firmware::HeartbeatState::kOperational);
}

// value and std in thousandths.
inline firmware::CanFrame estimate(int index, int64_t value_e3, int64_t std_e3,
                                   firmware::EstimateStatus status = firmware::EstimateStatus::kValid, int node = 1) {
  firmware::ParameterEstimate parameter;
  parameter.value = firmware::Scaled::ratio(value_e3, 1000);
  parameter.std = firmware::Scaled::ratio(std_e3, 1000);
  parameter.status = status;
  return firmware::pack_estimate(node, index, parameter, 1);
}

inline firmware::CanFrame name(int index, firmware::TermKind kind, int place_a, int place_b, int node = 1) {
  firmware::ParameterDescription description;
  description.index = static_cast<uint8_t>(index);
  description.count = 5;
  description.kind = kind;
  description.place_a = static_cast<uint8_t>(place_a);
  description.place_b = static_cast<uint8_t>(place_b);
  return firmware::pack_parameter(node, description);
}

}  // namespace frames
