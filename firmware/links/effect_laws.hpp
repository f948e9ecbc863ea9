// The fixed-point law of each column from TermKind::kGravity on, one row a law. The laws in double that they are checked
// against stand in host_sim/vocabulary (tests/vocabulary/core_laws_test.cpp).
#pragma once
#include <cstdint>

#include "firmware/configuration/configuration.hpp"

namespace firmware {

constexpr int kLawFraction = 26;
constexpr int64_t kLawOne = int64_t{1} << kLawFraction;
constexpr int kLawTimeBits = 20;  // time runs to 2^20 samples, then stands

struct LawRatio {  // multiplication of a Q26 number by a constant: (x * mantissa) >> shift
  int32_t mantissa = 0;
  int8_t shift = 0;
};
inline int64_t times(LawRatio ratio, int64_t x) { return (x * ratio.mantissa) >> ratio.shift; }

// The shape parameters of a term as its law wants them.
struct LawShape {
  LawRatio ratio;       // see ShapeUse
  int64_t gap_q26 = 0;  // in units of the elongation's range
  uint32_t phase = 0;   // 2^-32 turns
};

enum class ShapeUse : uint8_t {
  kNone,
  kGap,  // gap_q26
  kTurns,  // ratio and phase: a turn each `shape` of the elongation (each 2 pi where there is none), ahead by the second shape
  kDecayOfRate,        // ratio: log2(e) times the rate's range over the shape
  kDecayOfElongation,  // ratio: log2(e) times the elongation's range over the shape
  kDecayOfTime,  // ratio: log2(e) times the sample period over the shape, in Q26; none where the shape is left out
};

struct LawPoint {
  int64_t u, w;   // Q26 of the link's ranges U and W
  uint32_t time;  // samples since the level's start
};

struct CoreLaw {
  TermKind kind;
  int8_t u_power, w_power;  // the column's unit is U^u_power W^w_power / 2^26
  ShapeUse use;
  int32_t (*force)(const LawPoint&, const LawShape&);  // at most 2^26 in size; nullptr: remembers the elongation's path
};

const CoreLaw& core_law(TermKind kind);  // from TermKind::kGravity on

// Bristles bent by a step of the elongation, Dahl's model solved exactly: z heads for the step's sign.
int64_t bent_bristles(int64_t z_q26, int64_t step_q26, const LawShape& shape);

}  // namespace firmware
