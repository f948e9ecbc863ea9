// The vocabulary: a row per effect, the one place that lists them. Whatever reads, writes, simulates, estimates, names or
// explains effects walks this table. docs/design.md says how to add one.
#pragma once
#include "firmware/vocabulary/effect_row.hpp"

namespace firmware {

namespace parameter {  // shapes that rows name; keys and names are the contract's

constexpr Unit kLength("m", "rad"), kSpeed("m/s", "rad/s"), kTime("s", "s"), kHertz("Hz", "Hz"), kPure("1", "1");

constexpr ShapeParameter kBacklashGap("gap", "backlash_gap", kLength, Range(RangeOf::kElongationPeak, 50, 800000),
                                      false, false, true);
constexpr ShapeParameter kEndStopGap("gap", "end_stop_gap", kLength, Range(RangeOf::kElongationPeak, 100000, 970000),
                                     false, false, true);
constexpr ShapeParameter kStribeckVelocity("stribeck_velocity", "stribeck_velocity", kSpeed,
                                           Range(RangeOf::kRateRms, 30000, 1100000), false, false, true);
constexpr ShapeParameter kPreslidingLength("presliding_length", "presliding_length", kLength,
                                           Range(RangeOf::kElongationRms, 500, 1500000), false, false, true);
constexpr ShapeParameter kBristleTime("bristle_time", "bristle_time", kTime,
                                      Range(RangeOf::kSlideTime, 20000, 50000000), true, true, false);
constexpr ShapeParameter kDriftTime("drift_time", "drift_time", kTime, Range(RangeOf::kDuration, 20000, 2000000), false,
                                    true, true);
constexpr ShapeParameter kCoggingPitch("pitch", "cogging_pitch", kLength,
                                       Range(RangeOf::kElongationPeak, 20000, 3000000), false, false, true);
constexpr ShapeParameter kCoggingPhase("phase", "cogging_phase", Unit("rad", "rad"), Range(RangeOf::kOne, 0, 6283185),
                                       true, true, true);
constexpr ShapeParameter kResonance("resonance", "resonance_frequency", kHertz,
                                    Range(RangeOf::kSamplingRate, 2000, 121000), false, false, false);
constexpr ShapeParameter kDampingRatio("damping_ratio", "resonance_damping_ratio", kPure,
                                       Range(RangeOf::kOne, 100, 500000), true, false, false);
constexpr ShapeParameter kMainsFrequency("frequency", "mains_frequency", kHertz,
                                         Range(RangeOf::kOne, 45000000, 65000000), false, false, false);
constexpr ShapeParameter kMainsPhase("phase", "mains_phase", Unit("rad", "rad"), Range(RangeOf::kOne, 0, 6283185), true,
                                     true, false);

constexpr ShapeParameter kDeadBand("dead_band", "drive_dead_band_width", Unit("N", "N m"),
                                   Range(RangeOf::kForcePeak, 1000, 900000), false, false, false);

}  // namespace parameter

namespace nature {
constexpr Nature kSpring(true, Memory::kNone, Events::kNone, AtRest::kPasses, Work::kOneSign);
constexpr Nature kUnevenSpring(true, Memory::kNone, Events::kNone, AtRest::kPasses, Work::kEitherSign);
constexpr Nature kGapSpring(true, Memory::kNone, Events::kGap, AtRest::kPasses, Work::kOneSign);
constexpr Nature kDamper(false, Memory::kNone, Events::kNone, AtRest::kPasses, Work::kOneSign);
constexpr Nature kDirectedDamper(false, Memory::kNone, Events::kRateZero, AtRest::kPasses, Work::kOneSign);
constexpr Nature kUnevenDamper(false, Memory::kNone, Events::kRateZero, AtRest::kPasses, Work::kEitherSign);
constexpr Nature kFriction(false, Memory::kNone, Events::kRateZero, AtRest::kHolds, Work::kOneSign);
}  // namespace nature

inline constexpr EffectRow kEffectTable[] = {
// clang-format off
#include "firmware/vocabulary/rows_of_rig_files.inc"
#include "firmware/vocabulary/rows_on_links.inc"
#include "firmware/vocabulary/rows_on_dofs_and_channels.inc"
    // clang-format on
};

constexpr bool in_order() {
  for (int i = 0; i < kEffectKinds; ++i)
    if (static_cast<int>(kEffectTable[i].kind) != i) return false;
  return true;
}
static_assert(sizeof(kEffectTable) / sizeof(kEffectTable[0]) == kEffectKinds, "one row for each EffectKind");
static_assert(in_order(), "rows in the order of EffectKind");

constexpr const EffectRow& row_of(EffectKind kind) { return kEffectTable[static_cast<int>(kind)]; }

// The row that a column of the core is named after: the own term or the extension, not a correction of one.
constexpr const EffectRow& row_of(TermKind term) {
  for (const EffectRow& row : kEffectTable)
    if (row.core.estimable && row.core.term == term && row.role != EffectRole::kCorrection) return row;
  return kEffectTable[0];
}

constexpr bool terms_covered() {
  for (int t = 0; t < kTermKinds; ++t) {
    const EffectRow& row = row_of(static_cast<TermKind>(t));
    if (!row.core.estimable || static_cast<int>(row.core.term) != t) return false;
  }
  return true;
}
static_assert(terms_covered(), "every TermKind is the column of one row");

constexpr bool same_word(const char* a, const char* b) {
  while (*a != '\0' && *a == *b) ++a, ++b;
  return *a == *b;
}
constexpr bool unique() {
  for (int i = 0; i < kEffectKinds; ++i)
    for (int j = 0; j < i; ++j) {
      if (same_word(kEffectTable[i].word.text, kEffectTable[j].word.text)) return false;
      if (kEffectTable[i].can.number != 0 && kEffectTable[i].can.number == kEffectTable[j].can.number) return false;
    }
  return true;
}
static_assert(unique(), "no word and no CAN number twice");

// nullptr: not a word of the vocabulary.
constexpr const EffectRow* find_effect(const char* word) {
  for (const EffectRow& row : kEffectTable)
    if (same_word(row.word.text, word)) return &row;
  return nullptr;
}

}  // namespace firmware
