// Checks a programme before anything moves.
#include "firmware/excitation/programme.hpp"

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

// The steepest change of a sine in one sample is 2 A sin(step / 2); a ramp adds A / ramp_samples to it.
bool too_steep(const ExcitationLevel& level, const DriveLimits& limits) {
  if (level.kind == ExcitationKind::kRandomBand)
    return false;  // its rare steep steps are limited and counted while running
  const int64_t chord = (static_cast<int64_t>(level.amplitude.raw) * sine(level.phase_step / 2).raw) >> 30;
  return chord + level.amplitude.raw / static_cast<int64_t>(level.ramp_samples) > limits.step_per_sample.raw;
}

bool settle_out_of_range(const ExcitationLevel& level) {
  const SettleCriterion& settle = level.settle;
  if (settle.block_samples == 0) return false;
  return settle.block_samples > SettleDetector::kMaxBlockSamples || settle.blocks < 2 ||
         settle.blocks > SettleDetector::kMaxBlocks || level.settle_limit_samples == 0;
}

ProgrammeFault check_level(const ExcitationLevel& level, const DriveLimits& limits) {
  if (level.amplitude.raw <= 0 || limits.magnitude < level.amplitude) return ProgrammeFault::kAmplitude;
  const ProgrammeFault frequency = check_frequency(level);
  if (frequency != ProgrammeFault::kNone) return frequency;
  if (level.measure_samples == 0 || level.ramp_samples == 0) return ProgrammeFault::kLength;
  if (too_steep(level, limits)) return ProgrammeFault::kSlew;
  return settle_out_of_range(level) ? ProgrammeFault::kSettle : ProgrammeFault::kNone;
}

}  // namespace

ProgrammeFault check(const ExcitationProgramme& programme, uint8_t& level) {
  if (programme.level_count > kMaxLevels) return ProgrammeFault::kTooManyLevels;
  for (uint8_t i = 0; i < programme.level_count; ++i) {
    const ProgrammeFault fault = check_level(programme.levels[i], programme.limits);
    if (fault != ProgrammeFault::kNone) {
      level = i;
      return fault;
    }
  }
  return ProgrammeFault::kNone;
}

}  // namespace firmware
