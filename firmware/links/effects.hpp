// Force laws of the extension terms (TermKind from kGravity on): one column per term, the force per unit coefficient.
//
// Elongation and rate are brought to Q26 of the link's own ranges U and W (powers of two that hold the codes' full scale),
// so a column entry is at most one (2^26) and its unit follows from the law: u^3 has U^3 / 2^26, w|w| has W^2 / 2^26.
// Formats: links/node_difference.hpp; products of two Q26 numbers 2^52, shifted back to Q26.
#pragma once
#include "firmware/acquisition/columns.hpp"
#include "firmware/configuration/configuration.hpp"
#include "firmware/links/effect_laws.hpp"
#include "firmware/links/node_difference.hpp"

namespace firmware {

class Effects {
 public:
  // Writes the unit of every effect's column to column_unit[kEffectColumn + number], in the order of the terms.
  void configure(const CoreConfiguration& configuration, Scaled* column_unit);
  bool complete() const { return complete_; }  // every effect term has a column
  // A new level, or what follows a gap in it: memory of hysteresis starts again, and time at so many samples of the level.
  void restart(uint32_t time = 0);
  bool time_is_out() const { return time_is_out_; }  // a law would have gone on with time where its column stands still
  // Fills positions [from, to). What remembers (hysteresis, time) goes on from position from + advance at the next call.
  void fill(Frame& frame, int from, int to, int advance);

 private:
  struct Effect {
    TermKind kind = TermKind::kGravity;
    NodeDifference elongation, rate;
    LawShape shape;
    LawForce memory;     // bristles at the next start position
    bool moved = false;  // false: the bristles still stand as they start
    uint32_t time = 0;   // samples since the level's start, at the next start position
  };
  static void fill_bristles(Effect& effect, const Frame& frame, int from, int to, int advance, Column<LawForce> column);

  Effect effect_[kMaxEffectColumns];
  int count_ = 0;
  bool complete_ = true;
  bool time_is_out_ = false;
};

}  // namespace firmware
