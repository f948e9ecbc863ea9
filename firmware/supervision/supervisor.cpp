// See supervisor.hpp.
#include "firmware/supervision/supervisor.hpp"

namespace firmware {
namespace {

uint16_t saturate16(uint64_t value) { return static_cast<uint16_t>(value > 0xFFFF ? 0xFFFF : value); }

uint8_t channel_number(int node, int quantity) { return static_cast<uint8_t>(node * kQuantities + quantity); }

int32_t magnitude(int32_t code) { return code < 0 ? (code == INT32_MIN ? INT32_MAX : -code) : code; }

}  // namespace

void Supervisor::configure(const CoreConfiguration& core, const LimitConfiguration& limits, const DriveLimits& drive) {
  *this = Supervisor{};
  core_ = &core;
  limits_ = &limits;
  drive_ = drive;
}

void Supervisor::arm(uint64_t now_ns) {
  armed_ = true;
  last_sample_ns_ = now_ns;
  last_step_ns_ = now_ns;
  for (auto& node : saturated_in_row_)
    for (uint16_t& count : node) count = 0;
}

Fault Supervisor::trip(Fault fault) {
  if (stops_drive(fault.code)) {
    ++counters_.trips;
    if (!tripped()) latched_ = fault;
    armed_ = false;
  }
  return fault;
}

Fault Supervisor::stop_if_armed(Fault fault) { return armed_ ? trip(fault) : Fault{}; }

Fault Supervisor::check_sample(const RawSample& sample, uint64_t now_ns) {
  last_sample_ns_ = now_ns;
  Fault fault = check_sequence(sample);
  for (int node = 0; node < kMaxNodes; ++node) {
    if (node >= core_->dof_count && node != kBaseNode) continue;
    for (int quantity = 0; quantity < kQuantities; ++quantity) {
      const Fault found = check_channel(sample, node, quantity);
      if (stops_drive(found.code) && !stops_drive(fault.code)) fault = found;
    }
  }
  return fault;
}

Fault Supervisor::check_sequence(const RawSample& sample) {
  uint32_t missed = sequence_known_ ? sample.sequence - sequence_ - 1 : 0;
  sequence_known_ = true;
  sequence_ = sample.sequence;
  if (missed == 0) return Fault{};
  if (missed >= 0x80000000u) missed = 1;  // the counter stood still or went back: something is missing, how much is unknown
  counters_.missed_samples += missed;
  if (missed >= limits_->lost_in_row && armed_) {
    return trip({FaultCode::kSensorFramesLost, kNoChannel, saturate16(missed)});
  }
  return {FaultCode::kMissedSamples, kNoChannel, saturate16(missed)};
}

Fault Supervisor::check_channel(const RawSample& sample, int node, int quantity) {
  const ChannelConfiguration& channel = core_->channels[node][quantity];
  if (!channel.present) return Fault{};
  const int32_t code = sample.code[node][quantity];
  uint16_t& in_row = saturated_in_row_[node][quantity];
  if (magnitude(code) >= channel.full_scale_code) {
    ++counters_.saturated_samples;
    if (in_row < 0xFFFF) ++in_row;
    if (in_row >= limits_->saturated_in_row) {
      return stop_if_armed({FaultCode::kSensorSaturated, channel_number(node, quantity), in_row});
    }
  } else {
    in_row = 0;
  }
  const int32_t limit = limits_->response_limit_code[node][quantity];
  const int64_t value = static_cast<int64_t>(code) - channel.offset_code;
  if (limit == 0 || (value <= limit && value >= -static_cast<int64_t>(limit))) return Fault{};
  return stop_if_armed({FaultCode::kResponseLimit, channel_number(node, quantity),
                        static_cast<uint16_t>(static_cast<uint32_t>(code) >> 8)});
}

Fault Supervisor::check_time(uint64_t now_ns) {
  const uint64_t since_step_us = (now_ns - last_step_ns_) / 1000;
  const uint64_t since_sample_us = (now_ns - last_sample_ns_) / 1000;
  last_step_ns_ = now_ns;
  if (!armed_) return Fault{};
  if (since_step_us > limits_->step_timeout_us) {
    return trip({FaultCode::kStepLate, kNoChannel, saturate16(since_step_us / 1000)});
  }
  if (since_sample_us > limits_->sample_timeout_us) {
    return trip({FaultCode::kSensorFramesLost, kNoChannel, saturate16(since_sample_us / 1000)});
  }
  return Fault{};
}

Fault Supervisor::check_drive(Drive command) {
  const int64_t change = static_cast<int64_t>(command.raw) - last_command_.raw;
  last_command_ = command;
  const bool too_large = command.raw > drive_.magnitude.raw || command.raw < -drive_.magnitude.raw;
  const bool too_steep = command.raw != 0 && (change > drive_.step_per_sample.raw || change < -static_cast<int64_t>(drive_.step_per_sample.raw));
  if (!too_large && !too_steep) return Fault{};
  return stop_if_armed({FaultCode::kDriveLimit, kNoChannel, static_cast<uint16_t>(static_cast<uint32_t>(command.raw) >> 16)});
}

Fault Supervisor::source_ended() { return stop_if_armed({FaultCode::kSensorFault, kNoChannel, 0}); }

}  // namespace firmware
