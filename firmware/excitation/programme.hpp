// The excitation programme as plain numbers: which levels, how long, when to go on.
#pragma once
#include <cstdint>

#include "firmware/configuration/capacity.hpp"
#include "firmware/excitation/drive.hpp"
#include "firmware/excitation/settle_detector.hpp"

namespace firmware {

enum class ExcitationKind : uint8_t {
  kSine,        // amplitude * sin(phase)
  kRandomBand,  // band-limited random between two frequencies; amplitude is the rms
  kFreeDecay,  // amplitude * cos(phase) is held until the rig has settled, then released; phase step 0: a constant pull
};

// Frequencies are phase steps per sample: 2^32 * f / sample rate.
struct ExcitationLevel {
  ExcitationKind kind = ExcitationKind::kSine;
  Drive amplitude;                    // 0 < amplitude
  uint32_t phase_step = 0;            // sine, free decay; random: lower band edge
  uint32_t high_phase_step = 0;       // random: upper band edge
  uint32_t seed = 1;                  // random
  uint32_t ramp_samples = 1;          // from zero or the amplitude before to its own, and to zero; at least 1
  SettleCriterion settle;             // when the response counts as settled
  uint32_t settle_limit_samples = 0;  // longest wait; then the level goes on as unsettled, or is left out
  bool skip_when_unsettled = false;   // for whole-cycle windows, which rest on a periodic response
  uint32_t measure_samples = 0;       // length of the window, at least 1; the core's margin comes on top
};

struct ExcitationProgramme {
  uint8_t level_count = 0;  // 0: the drive stays at zero and the controller listens only
  bool start_at_boot = false;
  DriveLimits limits;
  ExcitationLevel levels[kMaxLevels];
};

enum class ProgrammeFault : uint8_t {
  kNone,
  kTooManyLevels,
  kAmplitude,  // not positive, or over the drive limit
  kFrequency,  // at or over half the sample rate, zero for a sine, or an empty band
  kSlew,       // the sine or the ramp is steeper than the drive limits allow
  kLength,     // nothing to measure, or no ramp
  kSettle,     // block or number of blocks out of range, or no time limit
  kCapacity,   // not of the programme: the rig needs more than the core has room for (capacity.hpp)
};

// From one such level to the next the amplitude glides, with the phase running on.
bool same_sine(const ExcitationLevel& a, const ExcitationLevel& b);

// What is wrong with the programme, and in which level (level is untouched for kNone and kTooManyLevels).
ProgrammeFault check(const ExcitationProgramme& programme, uint8_t& level);

}  // namespace firmware
