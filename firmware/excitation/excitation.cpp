// See excitation.hpp for the course of a programme.
#include "firmware/excitation/excitation.hpp"

#include <algorithm>

#include "firmware/excitation/sine.hpp"

namespace firmware {
namespace {

int32_t towards(int32_t value, int32_t target, int32_t step) {
  if (value < target) return target - value > step ? value + step : target;
  return value - target > step ? value - step : target;
}

// Rounded down as long as the ramp gets one sample longer by it, else up.
int32_t ramp_step(int32_t height, int32_t samples) {
  const int32_t step = height / samples;
  return height % samples > step ? step + 1 : step;
}

}  // namespace

void Excitation::configure(const ExcitationProgramme& programme, int dof_count, uint32_t extra_samples) {
  *this = Excitation{};
  programme_ = &programme;
  dof_count_ = dof_count;
  extra_samples_ = extra_samples;
}

void Excitation::start() {
  if (programme_ == nullptr || programme_->level_count == 0) return;
  abort();
  enter_level(0);
}

void Excitation::stop() {
  if (state_ == ExcitationState::kIdle || state_ == ExcitationState::kDone) return;
  last_ = true;
  begin_ramp(true);
}

// From the level's amplitude, or from a larger one that a glide has not left yet, in ramp_samples.
void Excitation::begin_ramp(bool to_zero) {
  const ExcitationLevel& level = current();
  const auto samples = static_cast<int32_t>(std::min<uint32_t>(level.ramp_samples, INT32_MAX));
  stopping_ = to_zero;
  rise_ = ramp_step(std::max(level.amplitude.raw, envelope_), samples);
  state_ = ExcitationState::kRamping;
}

void Excitation::abort() {
  state_ = ExcitationState::kIdle;
  stopping_ = false;
  last_ = false;
  envelope_ = 0;
  drive_ = Drive{};
}

void Excitation::enter_level(uint8_t level) {
  level_ = level;
  begin_ramp(false);
  unsettled_ = false;
  samples_ = 0;
  if (envelope_ == 0) phase_ = 0;
  const ExcitationLevel& entered = current();
  if (entered.kind == ExcitationKind::kRandomBand)
    noise_.begin(entered.phase_step, entered.high_phase_step, entered.seed);
}

ExcitationEvent Excitation::step(const int32_t* response_code) {
  ExcitationEvent event = ExcitationEvent::kNone;
  switch (state_) {
    case ExcitationState::kIdle:
    case ExcitationState::kDone:
      return event;
    case ExcitationState::kRamping:
      event = ramp();
      break;
    case ExcitationState::kSettling:
      event = settle(response_code);
      break;
    case ExcitationState::kMeasuring:
      event = measure();
      break;
  }
  command();
  return event;
}

ExcitationEvent Excitation::ramp() {
  const ExcitationLevel& level = current();
  const int32_t target = stopping_ ? 0 : level.amplitude.raw;
  envelope_ = towards(envelope_, target, rise_);
  if (envelope_ != target) return ExcitationEvent::kNone;
  if (!stopping_) {
    state_ = ExcitationState::kSettling;
    samples_ = 0;
    settle_.begin(level.settle, dof_count_);
    return ExcitationEvent::kNone;
  }
  if (!last_ && level_ + 1 < programme_->level_count) {
    enter_level(static_cast<uint8_t>(level_ + 1));
    return ExcitationEvent::kNone;
  }
  state_ = ExcitationState::kDone;
  return ExcitationEvent::kFinished;
}

ExcitationEvent Excitation::settle(const int32_t* response_code) {
  const ExcitationLevel& level = current();
  ++samples_;
  if (settle_.push(response_code)) return begin_measuring();
  if (samples_ < level.settle_limit_samples) return ExcitationEvent::kNone;
  unsettled_ = true;
  if (!level.skip_when_unsettled) return begin_measuring();
  leave_level();
  return ExcitationEvent::kLevelSkipped;
}

ExcitationEvent Excitation::begin_measuring() {
  state_ = ExcitationState::kMeasuring;
  samples_ = 0;
  if (current().kind == ExcitationKind::kFreeDecay) envelope_ = 0;
  return ExcitationEvent::kMeasureBegins;
}

ExcitationEvent Excitation::measure() {
  if (++samples_ < current().measure_samples + extra_samples_) return ExcitationEvent::kNone;
  leave_level();
  return ExcitationEvent::kMeasureEnds;
}

void Excitation::leave_level() {
  const bool more = level_ + 1 < programme_->level_count;
  if (more && same_sine(current(), programme_->levels[level_ + 1])) {
    enter_level(static_cast<uint8_t>(level_ + 1));
    return;
  }
  begin_ramp(true);
}

// The unlimited command of this sample, Q31 in int64.
int64_t Excitation::signal() {
  const ExcitationLevel& level = current();
  if (level.kind == ExcitationKind::kRandomBand) return noise_.next(Drive::from_raw(envelope_));
  const Drive wave = level.kind == ExcitationKind::kSine ? sine(phase_) : cosine(phase_);
  phase_ += level.phase_step;
  return rescale<Drive>(Fixed<int32_t, 31>::from_raw(envelope_) * wave).raw;
}

void Excitation::command() {
  const DriveLimits& limits = programme_->limits;
  const bool released = envelope_ == 0;
  const int64_t wanted = released ? 0 : signal();
  int32_t allowed = clamp_magnitude(wanted, limits.magnitude.raw);
  if (!released) {
    const int64_t change = static_cast<int64_t>(allowed) - drive_.raw;
    allowed = static_cast<int32_t>(drive_.raw + clamp_magnitude(change, limits.step_per_sample.raw));
  }
  drive_ = Drive::from_raw(allowed);
}

}  // namespace firmware
