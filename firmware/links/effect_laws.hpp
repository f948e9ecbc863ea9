// The fixed-point law of each column from TermKind::kGravity on, one row a law. The laws in double that they are checked
// against stand in host_sim/vocabulary (tests/vocabulary/core_laws_test.cpp).
#pragma once
#include <cstdint>

#include "firmware/acquisition/columns.hpp"
#include "firmware/configuration/configuration.hpp"

namespace firmware {

// Elongation, rate and force of a law, of the link's ranges U and W.
using LawNumber = Fixed<int64_t, LawForce::kFractionBits>;
constexpr int kLawFraction = LawNumber::kFractionBits;
constexpr LawNumber kLawOne = LawNumber::from_raw(int64_t{1} << kLawFraction);
constexpr int kLawTimeBits = 20;  // time runs to 2^20 samples, then stands

struct LawRatio {  // multiplication of a LawNumber or of a count of samples by a constant: (x * mantissa) >> shift
  int32_t mantissa = 0;
  int8_t shift = 0;
};
inline int64_t times(LawRatio ratio, int64_t raw) { return (raw * ratio.mantissa) >> ratio.shift; }

// The shape parameters of a term as its law wants them.
struct LawShape {
  LawRatio ratio;      // see ShapeUse
  LawNumber gap;       // in units of the elongation's range
  uint32_t phase = 0;  // 2^-32 turns
};

enum class ShapeUse : uint8_t {
  kNone,
  kGap,  // gap
  kTurns,  // ratio and phase: a turn each `shape` of the elongation (each 2 pi where there is none), ahead by the second shape
  kDecayOfRate,        // ratio: log2(e) times the rate's range over the shape
  kDecayOfElongation,  // ratio: log2(e) times the elongation's range over the shape
  kDecayOfTime,  // ratio: log2(e) times the sample period over the shape, in Q26; none where the shape is left out
};

struct LawPoint {
  LawNumber u, w;
  uint32_t time;  // samples since the level's start
};

struct CoreLaw {
  TermKind kind;
  int8_t u_power, w_power;  // the column's unit is U^u_power W^w_power / 2^26
  ShapeUse use;
  LawForce (*force)(const LawPoint&, const LawShape&);  // at most one in size; nullptr: remembers the elongation's path
};

const CoreLaw& core_law(TermKind kind);  // from TermKind::kGravity on

// Whether the force of a term is another one at another elongation: where no term of a link is, its ends need no displacement.
bool reads_elongation(TermKind kind);

// Bristles bent by a step of the elongation, Dahl's model solved exactly: z heads for the step's sign.
LawNumber bent_bristles(LawNumber z, LawNumber step, const LawShape& shape);

}  // namespace firmware
