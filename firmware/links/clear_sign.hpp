// Where the direction of a link's motion is beyond doubt, so that the sign of its friction carries no noise.
//
// The rate is interpolated from its neighbours without the sample itself, so that neither the sign nor the choice of samples
// knows the noise of the equation that it is used in. Its noise is measured as it goes: that rate differs from the sample's own
// by 1.39 standard deviations of white noise, by 1.11 in the mean of the magnitude; four such means are 4.45 deviations, which
// noise passes on the wrong side in 1 of 10^5 samples. The sample's own sign has to agree, which settles samples beside a kink
// of clean signals. While a link sticks, nothing is clear.
//
// Where the rate is derived its neighbours share most of its noise and show little of it: of a low-passed slope a twentieth. There
// the noise is known that the channels and the filters give the rate, and a link whose rate is no more than that is at rest: nothing
// is clear. A fading mean of the last 64 samples decides: a derived rate has a tenth of the motion in noise, and what a sample's own
// noise has chosen would be biased by it. A measured velocity that has passed a low-pass has a hundredth: there the sample has to be
// beyond three deviations too, for a link sticks and slips again in less than 64, and the mean beyond six: of a rate that hardly passes
// the limit, noise chooses the most.
//
// Formats: rate below 2^35 (link_motion.hpp), times 6 below 2^38; sum of at most 2^11 of them below 2^50.
#pragma once
#include "firmware/links/link_motion.hpp"

namespace firmware {

class ClearSign {
 public:
  // measured: the rate is that of measured velocities; else it is derived, and a part of its noise is too slow for neighbours to
  // show. slow: the rate has passed a high-pass, which shifts it by up to an eighth of its mean magnitude.
  // noise: standard deviation of the rate, in its common unit; 0: not known.
  void configure(const RateGains& gains, bool measured, bool slow, const Scaled& noise);
  void restart();  // a new level: its noise is measured anew
  // For positions [from, to): clear[i]: is it; sign[i] is that of the rate itself. What is known of the
  // noise goes on from position from + advance at the next call. Rates are read two positions further on either side.
  void fill(const Frame& frame, int from, int to, int advance, bool* clear, Column<Code> sign);

 private:
  static constexpr uint32_t kLongMemory = 2048;  // samples; then the means forget half

  struct Known {
    Rate differences, magnitudes;  // sums of 6 |rate - interpolated| and 6 |rate|
    Rate near;                     // fading sum of 6 |rate|, 64 times its mean
    uint32_t count = 0;
    // Of the link, beside the count that leaves room for them.
    bool measured = true, slow = false;
  };
  // around: six times the interpolated rate. Number: Code where a unit of both is one of the common unit, else Rate.
  template <typename Number>
  bool judge(Known& known, Number own, Number around) const;
  template <typename Number>
  void judge_block(const Number* w, int from, int to, int advance, bool* clear, Column<Code> sign);

  RateGains gains_;
  Rate least_;  // what near is at rest, at the most; 0: not known
  Known known_;
};

}  // namespace firmware
