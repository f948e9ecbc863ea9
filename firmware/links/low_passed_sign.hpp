// The sign of friction through the low-pass that all other signals of its equation have passed: the sign of a low-passed
// velocity jumps where the low-passed friction passes smoothly. The signs come as many samples early as the filter is long on
// either side.
#pragma once
#include <cstdint>

#include "firmware/acquisition/columns.hpp"
#include "firmware/configuration/configuration.hpp"

namespace firmware {

class LowPassedSign {
 public:
  void restart() { state_ = State{}; }
  // sign: -1, 0, 1; passed: the filtered sign, may be the same column; clear in: is the sign known; clear out: false
  // where signs that are not known make up over 1/32 of the filter's weight, 1/4 where the rate is that of measured velocities. Positions [from, to); goes on from
  // from + advance at the next call. Sums of at most 25 taps of 2^20: 31 bits.
  void fill(const CoreConfiguration& configuration, bool measured, int from, int to, int advance, Column<Code> sign,
            Column<PassedSign> passed, bool* clear);

 private:
  static constexpr int kTaps = 2 * kSignFilterHalf + 1;
  struct State {  // the last samples, newest at `at` - 1
    int8_t sign[kTaps] = {};
    bool known[kTaps] = {};
    int at = 0;
  };
  State state_;
};

}  // namespace firmware
