// Checks a programme before anything moves.
#include "firmware/excitation/programme.hpp"

#include <algorithm>

#include "firmware/excitation/sine.hpp"

namespace firmware {
namespace {

constexpr uint32_t kNyquistStep = 0x80000000u;

ProgrammeFault check_frequency(const ExcitationLevel& level) {
  if (level.phase_step >= kNyquistStep) return ProgrammeFault::kFrequency;
  if (level.kind == ExcitationKind::kSine && level.phase_step == 0) return ProgrammeFault::kFrequency;
  if (level.kind == ExcitationKind::kRandomBand &&
      (level.high_phase_step <= level.phase_step || level.high_phase_step >= kNyquistStep)) {
    return ProgrammeFault::kFrequency;
  }
  return ProgrammeFault::kNone;
}

// The steepest change of a sine in one sample is 2 A sin(step / 2); a ramp adds A / ramp_samples to it. A: the larger of the amplitudes
// that the ramp is between.
bool too_steep(const ExcitationLevel& level, int32_t from_raw, const DriveLimits& limits) {
  if (level.kind == ExcitationKind::kRandomBand)
    return false;  // its rare steep steps are limited and counted while running
  const int64_t most = std::max(level.amplitude.raw, from_raw);
  const int64_t chord = (most * sine(level.phase_step / 2).raw) >> 30;
  return chord + most / static_cast<int64_t>(level.ramp_samples) > limits.step_per_sample.raw;
}

bool settle_out_of_range(const ExcitationLevel& level) {
  const SettleCriterion& settle = level.settle;
  if (settle.block_samples == 0) return false;
  return settle.block_samples > SettleDetector::kMaxBlockSamples || settle.blocks < 2 ||
         settle.blocks > SettleDetector::kMaxBlocks || level.settle_limit_samples == 0;
}

ProgrammeFault check_level(const ExcitationLevel& level, int32_t from_raw, const DriveLimits& limits) {
  if (level.amplitude.raw <= 0 || limits.magnitude < level.amplitude) return ProgrammeFault::kAmplitude;
  const ProgrammeFault frequency = check_frequency(level);
  if (frequency != ProgrammeFault::kNone) return frequency;
  if (level.measure_samples == 0 || level.ramp_samples == 0) return ProgrammeFault::kLength;
  if (too_steep(level, from_raw, limits)) return ProgrammeFault::kSlew;
  return settle_out_of_range(level) ? ProgrammeFault::kSettle : ProgrammeFault::kNone;
}

}  // namespace

bool same_sine(const ExcitationLevel& a, const ExcitationLevel& b) {
  return a.kind == ExcitationKind::kSine && b.kind == ExcitationKind::kSine && a.phase_step == b.phase_step;
}

ProgrammeFault check(const ExcitationProgramme& programme, uint8_t& level) {
  if (programme.level_count > kMaxLevels) return ProgrammeFault::kTooManyLevels;
  for (uint8_t i = 0; i < programme.level_count; ++i) {
    const ExcitationLevel& entered = programme.levels[i];
    const bool glides = i > 0 && same_sine(programme.levels[i - 1], entered);
    const int32_t from_raw = glides ? programme.levels[i - 1].amplitude.raw : 0;
    const ProgrammeFault fault = check_level(entered, from_raw, programme.limits);
    if (fault != ProgrammeFault::kNone) {
      level = i;
      return fault;
    }
  }
  return ProgrammeFault::kNone;
}

}  // namespace firmware
