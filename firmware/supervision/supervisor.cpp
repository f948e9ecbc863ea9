// See supervisor.hpp.
#include "firmware/supervision/supervisor.hpp"

namespace firmware {
namespace {

uint32_t milliseconds(uint64_t time_us) {
  const uint64_t time_ms = time_us / 1000;
  return static_cast<uint32_t>(time_ms > UINT32_MAX ? UINT32_MAX : time_ms);
}

Alarm at(AlarmCause cause, uint32_t detail, int node, int quantity) {
  return {cause, detail, static_cast<uint8_t>(node), static_cast<uint8_t>(quantity)};
}

}  // namespace

void Supervisor::configure(const CoreConfiguration& core, const LimitConfiguration& limits, const DriveLimits& drive) {
  *this = Supervisor{};
  core_ = &core;
  limits_ = &limits;
  drive_ = drive;
}

void Supervisor::begin(uint64_t now_ns) {
  last_sample_ns_ = now_ns;
  last_step_ns_ = now_ns;
  for (auto& node : saturated_in_row_)
    for (uint16_t& count : node) count = 0;
}

Alarm Supervisor::check_sample(const RawSample& sample, uint64_t now_ns, bool live) {
  const bool has_time = sample.time_ns != 0 && sample.time_ns <= now_ns;
  last_sample_ns_ = has_time ? sample.time_ns : now_ns;
  Alarm alarm = check_sequence(sample, live);
  const uint64_t age_us = (now_ns - last_sample_ns_) / 1000;
  if (live && age_us > limits_->sample_timeout_us && !stops_drive(alarm.cause))
    alarm = {AlarmCause::kSensorLost, milliseconds(age_us)};
  for (int node = 0; node < kMaxNodes; ++node) {
    if (node >= core_->dof_count && node != kBaseNode) continue;
    for (int quantity = 0; quantity < kQuantities; ++quantity) {
      const Alarm found = check_channel(sample, node, quantity, live);
      if (stops_drive(found.cause) && !stops_drive(alarm.cause)) alarm = found;
    }
  }
  return alarm;
}

Alarm Supervisor::check_sequence(const RawSample& sample, bool live) {
  uint32_t missed = sequence_known_ ? sample.sequence - sequence_ - 1 : 0;
  sequence_known_ = true;
  sequence_ = sample.sequence;
  if (missed == 0) return Alarm{};
  if (missed >= 0x80000000u)
    missed = 1;  // the counter stood still or went back: something is missing, how much is unknown
  counters_.missed_samples += missed;
  return {live && missed >= limits_->lost_in_row ? AlarmCause::kSensorLost : AlarmCause::kSamplesMissed, missed};
}

Alarm Supervisor::check_channel(const RawSample& sample, int node, int quantity, bool live) {
  const ChannelConfiguration& channel = core_->channels[node][quantity];
  if (!channel.present) return Alarm{};
  const int32_t code = sample.code[node][quantity];
  uint16_t& in_row = saturated_in_row_[node][quantity];
  if (code <= channel.lowest_code || code >= channel.highest_code) {
    ++counters_.saturated_samples;
    if (in_row < 0xFFFF) ++in_row;
    if (live && in_row >= limits_->saturated_in_row) return at(AlarmCause::kSensorSaturated, in_row, node, quantity);
  } else {
    in_row = 0;
  }
  const int32_t limit = limits_->response_limit_code[node][quantity];
  const int64_t value = static_cast<int64_t>(code) - channel.offset_code;
  if (!live || limit == 0 || (value <= limit && value >= -static_cast<int64_t>(limit))) return Alarm{};
  return at(AlarmCause::kResponseLimit, static_cast<uint32_t>(code), node, quantity);
}

Alarm Supervisor::check_time(uint64_t now_ns, bool live) {
  const uint64_t since_step_us = (now_ns - last_step_ns_) / 1000;
  const uint64_t since_sample_us = (now_ns - last_sample_ns_) / 1000;
  last_step_ns_ = now_ns;
  if (!live) return Alarm{};
  if (since_step_us > limits_->step_timeout_us) return {AlarmCause::kStepLate, milliseconds(since_step_us)};
  if (since_sample_us > limits_->sample_timeout_us) return {AlarmCause::kSensorLost, milliseconds(since_sample_us)};
  return Alarm{};
}

Alarm Supervisor::check_drive(Drive command, bool live) {
  const int64_t change = static_cast<int64_t>(command.raw) - last_command_.raw;
  last_command_ = command;
  const bool too_large = command.raw > drive_.magnitude.raw || command.raw < -drive_.magnitude.raw;
  const int64_t steepest = drive_.step_per_sample.raw;
  const bool too_steep = command.raw != 0 && (change > steepest || change < -steepest);
  if (!live || (!too_large && !too_steep)) return Alarm{};
  return {AlarmCause::kDriveLimit, static_cast<uint32_t>(command.raw)};
}

Alarm Supervisor::source_ended(bool live) const { return live ? Alarm{AlarmCause::kSensorFault} : Alarm{}; }

}  // namespace firmware
