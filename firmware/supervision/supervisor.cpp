// See supervisor.hpp.
#include "firmware/supervision/supervisor.hpp"

namespace firmware {
namespace {

uint32_t milliseconds(uint64_t time_us) {
  const uint64_t time_ms = time_us / 1000;
  return static_cast<uint32_t>(time_ms > UINT32_MAX ? UINT32_MAX : time_ms);
}

// By a whole microsecond; without the division, which a small processor does in software.
bool over(uint64_t time_ns, uint32_t limit_us) { return time_ns >= (uint64_t{limit_us} + 1) * 1000; }

Alarm at(AlarmCause cause, uint32_t detail, int node, int quantity) {
  return {cause, detail, static_cast<uint8_t>(node), static_cast<uint8_t>(quantity)};
}

}  // namespace

void Supervisor::configure(const CoreConfiguration& core, const LimitConfiguration& limits, const DriveLimits& drive) {
  *this = Supervisor{};
  core_ = &core;
  limits_ = &limits;
  drive_ = drive;
  for (int node = 0; node < kMaxNodes; ++node) {
    if (node >= core.dof_count && !(node == kBaseNode && core.base_present)) continue;
    for (int quantity = 0; quantity < kQuantities; ++quantity) {
      const ChannelConfiguration& configured = core.channels[node][quantity];
      if (!configured.present) continue;
      Channel& channel = channel_[channel_count_++];
      const int64_t count = int64_t{configured.highest_code} - configured.lowest_code - 1;
      channel.inside = configured.lowest_code + 1;
      channel.count = count > 0 ? static_cast<uint32_t>(count) : 0;
      channel.offset = configured.offset_code;
      channel.limit = limits.response_limit_code[node][quantity];
      channel.node = static_cast<uint8_t>(node);
      channel.quantity = static_cast<uint8_t>(quantity);
    }
  }
}

void Supervisor::begin(uint64_t now_ns) {
  last_sample_ns_ = now_ns;
  last_step_ns_ = now_ns;
  for (Channel& channel : channel_) channel.saturated_in_row = 0;
}

Alarm Supervisor::check_sample(const RawSample& sample, uint64_t now_ns, bool live) {
  const bool has_time = sample.time_ns != 0 && sample.time_ns <= now_ns;
  last_sample_ns_ = has_time ? sample.time_ns : now_ns;
  Alarm alarm = check_sequence(sample, live);
  if (live && over(now_ns - last_sample_ns_, limits_->sample_timeout_us) && !stops_drive(alarm.cause))
    alarm = {AlarmCause::kSensorLost, milliseconds((now_ns - last_sample_ns_) / 1000)};
  for (Channel *channel = channel_, *end = channel_ + channel_count_; channel != end; ++channel) {
    const int32_t code = sample.code[channel->node][channel->quantity];
    const bool saturated = static_cast<uint32_t>(code) - static_cast<uint32_t>(channel->inside) >= channel->count;
    if (!saturated && channel->saturated_in_row == 0 && (!live || channel->limit == 0)) continue;
    const Alarm found = judge_code(*channel, code, live);
    if (stops_drive(found.cause) && !stops_drive(alarm.cause)) alarm = found;
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

Alarm Supervisor::judge_code(Channel& channel, int32_t code, bool live) {
  uint16_t& in_row = channel.saturated_in_row;
  if (static_cast<uint32_t>(code) - static_cast<uint32_t>(channel.inside) >= channel.count) {
    ++counters_.saturated_samples;
    if (in_row < 0xFFFF) ++in_row;
    if (live && in_row >= limits_->saturated_in_row)
      return at(AlarmCause::kSensorSaturated, in_row, channel.node, channel.quantity);
  } else {
    in_row = 0;
  }
  const int64_t value = static_cast<int64_t>(code) - channel.offset, limit = channel.limit;
  if (!live || limit == 0 || (value <= limit && value >= -limit)) return Alarm{};
  return at(AlarmCause::kResponseLimit, static_cast<uint32_t>(code), channel.node, channel.quantity);
}

Alarm Supervisor::check_time(uint64_t now_ns, bool live) {
  const uint64_t since_step_ns = now_ns - last_step_ns_, since_sample_ns = now_ns - last_sample_ns_;
  last_step_ns_ = now_ns;
  if (!live) return Alarm{};
  if (over(since_step_ns, limits_->step_timeout_us)) return {AlarmCause::kStepLate, milliseconds(since_step_ns / 1000)};
  if (over(since_sample_ns, limits_->sample_timeout_us))
    return {AlarmCause::kSensorLost, milliseconds(since_sample_ns / 1000)};
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
