// The sign of friction through the high-pass that all other signals of its equation have passed: the high-passed sign is not the
// sign of a high-passed velocity.
#pragma once
#include "firmware/configuration/configuration.hpp"

namespace firmware {

class HighPassedSign {
 public:
  void restart() { state_ = State{}; }
  // sign: -1, 0, 1 in, the filtered column out, positions [from, to); goes on from from + advance at the next call.
  // Sections as in conditioning: pole 1 - 2^-shift; states Q16 of 2^20: below 2^38.
  void fill(int order, int shift, int from, int to, int advance, int32_t* sign);

 private:
  struct State {
    bool started = false;
    int64_t section[3] = {}, previous[3] = {};
  };
  State state_;
};

}  // namespace firmware
