// The sign of friction through the high-pass that all other signals of its equation have passed: the high-passed sign is not the
// sign of a high-passed velocity.
#pragma once
#include "firmware/acquisition/columns.hpp"
#include "firmware/configuration/configuration.hpp"

namespace firmware {

class HighPassedSign {
 public:
  void restart() { state_ = State{}; }
  // The column in place: -1, 0, 1, or what has come through the low-pass. Positions [from, to); goes on from from + advance at
  // the next call. Sections as in conditioning: pole 1 - 2^-shift; states below 2^39.
  void fill(int order, int shift, int from, int to, int advance, Column<PassedSign> sign);

 private:
  using Section = Fixed<int64_t, PassedSign::kFractionBits + 16>;
  struct State {
    bool started = false;
    Section section[3], previous[3];
  };
  State state_;
};

}  // namespace firmware
