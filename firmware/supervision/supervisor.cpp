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
      channel.place = static_cast<uint16_t>(node * kQuantities + quantity);
      has_limits_ = has_limits_ || channel.limit != 0;
    }
  }
  alike_ = true;
  for (int c = 1; c < channel_count_; ++c)
    alike_ = alike_ && channel_[c].inside == channel_[0].inside && channel_[c].count == channel_[0].count;
}

void Supervisor::begin(uint64_t now_ns) {
  last_sample_ns_ = now_ns;
  last_step_ns_ = now_ns;
  last_command_ = Drive{};  // a start begins at rest, whatever the stop before it cut off
  for (Channel& channel : channel_) channel.saturated_in_row = 0;
  any_in_row_ = false;
}

Alarm Supervisor::check_sample(const RawSample& sample, uint64_t now_ns, bool live) {
  last_sample_ns_ = has_time(sample, now_ns) ? sample.time_ns : now_ns;
  Alarm alarm;
  const uint32_t missed = sequence_known_ ? sample.sequence - sequence_ - 1 : 0;
  sequence_known_ = true;
  sequence_ = sample.sequence;
  if (missed != 0) alarm = judge_gap(missed, live);
  if (live && over(now_ns - last_sample_ns_, limits_->sample_timeout_us) && !stops_drive(alarm.cause))
    alarm = {AlarmCause::kSensorLost, milliseconds((now_ns - last_sample_ns_) / 1000)};
  if (!any_in_row_ && !(live && has_limits_) && all_inside(sample)) return alarm;
  const Alarm found = judge_codes(sample, live);
  return found && !stops_drive(alarm.cause) ? found : alarm;
}

// The first alarm of a channel that stops the drive.
Alarm Supervisor::judge_codes(const RawSample& sample, bool live) {
  Alarm first;
  any_in_row_ = false;
  for (Channel *channel = channel_, *end = channel_ + channel_count_; channel != end; ++channel) {
    const Alarm found = judge_code(*channel, sample.code[channel->node][channel->quantity], live);
    any_in_row_ = any_in_row_ || channel->saturated_in_row != 0;
    if (stops_drive(found.cause) && !first) first = found;
  }
  if (any_in_row_) ++counters_.saturated_samples;
  return first;
}

// No channel at a rail: the usual case.
bool Supervisor::all_inside(const RawSample& sample) const {
  const int32_t* code = &sample.code[0][0];
  const Channel *channel = channel_, *end = channel_ + channel_count_;
  if (alike_) {
    const uint32_t inside = static_cast<uint32_t>(channel_->inside), count = channel_->count;
    while (channel != end && static_cast<uint32_t>(code[channel->place]) - inside < count) ++channel;
  } else {
    while (channel != end &&
           static_cast<uint32_t>(code[channel->place]) - static_cast<uint32_t>(channel->inside) < channel->count)
      ++channel;
  }
  return channel == end;
}

Alarm Supervisor::judge_gap(uint32_t missed, bool live) {
  if (missed >= 0x80000000u)
    missed = 1;  // the counter stood still or went back: something is missing, how much is unknown
  counters_.missed_samples += missed;
  return {live && missed >= limits_->lost_in_row ? AlarmCause::kSensorLost : AlarmCause::kSamplesMissed, missed};
}

Alarm Supervisor::judge_code(Channel& channel, int32_t code, bool live) {
  uint16_t& in_row = channel.saturated_in_row;
  if (static_cast<uint32_t>(code) - static_cast<uint32_t>(channel.inside) >= channel.count) {
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

Alarm Supervisor::judge_time(uint64_t since_step_ns, uint64_t since_sample_ns) const {
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
