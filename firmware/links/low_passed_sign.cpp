#include "firmware/links/low_passed_sign.hpp"

namespace firmware {
namespace {

// Of the filter's weight. A wrong sign is off by two: 1/32 leaves friction known to a sixteenth of itself. Where the velocity is
// measured what is not known are reversals, halves of either sign: a quarter may be.
constexpr PassedSign kMostUnknownDerived = PassedSign::from_raw((1 << PassedSign::kFractionBits) / 32);
constexpr PassedSign kMostUnknownMeasured = PassedSign::from_raw((1 << PassedSign::kFractionBits) / 4);
constexpr int kMostTaps = 2 * kSignFilterHalf + 1;

// Running sums of the taps: of the first k.
struct TapSums {
  PassedSign of[kMostTaps + 1];
};

// The filter's answer to values that seldom change, from the changes in its window alone (summation by parts, exact):
//   sum over k of tap[k] v[k] = v[last] T[taps] - sum over k > 0 of (v[k] - v[k - 1]) T[k],  T[k] = sum of the taps before k.
class StepsInWindow {
 public:
  StepsInWindow(const TapSums& sums, int taps) : sums_(sums), taps_(taps) {}
  void add(int value) {
    if (value != last_) {
      change_[count_] = static_cast<int8_t>(value - last_);
      at_[count_++] = static_cast<uint8_t>(next_);
      last_ = value;
    }
    ++next_;
    while (first_ < count_ && at_[first_] + taps_ <= next_) ++first_;  // at the window's oldest sample or before it
  }
  PassedSign sum() const {
    PassedSign sum = last_ * sums_.of[taps_];
    const int oldest = next_ - taps_;
    for (int c = first_; c < count_; ++c) sum = sum - change_[c] * sums_.of[at_[c] - oldest];
    return sum;
  }

 private:
  static constexpr int kMost = kMostTaps + kFrameStride;  // values that one call of fill() sees
  static_assert(kMost < 256, "counted in 8 bits");
  const TapSums& sums_;
  int taps_, last_ = 0, next_ = 0, first_ = 0, count_ = 0;
  int8_t change_[kMost];
  uint8_t at_[kMost];
};

}  // namespace

void LowPassedSign::fill(const CoreConfiguration& configuration, bool measured, int from, int to, int advance,
                         Column<Code> sign, Column<PassedSign> passed, bool* clear) {
  const int taps = 2 * configuration.sign_half_length + 1;
  TapSums sums, sizes;
  for (int k = 0; k < taps; ++k) {
    sums.of[k + 1] = sums.of[k] + configuration.sign_tap[k];
    sizes.of[k + 1] = sizes.of[k] + size_of(configuration.sign_tap[k]);
  }
  const PassedSign most_unknown = measured ? kMostUnknownMeasured : kMostUnknownDerived;
  StepsInWindow signs(sums, taps), unknown(sizes, taps);
  for (int k = 0, at = state_.at; k < taps; ++k, at = at + 1 == taps ? 0 : at + 1) {  // oldest first
    signs.add(state_.sign[at]);
    unknown.add(state_.known[at] ? 0 : 1);
  }
  State at_next = state_;
  for (int i = from; i < to; ++i) {
    if (i == from + advance) at_next = state_;
    state_.sign[state_.at] = static_cast<int8_t>(sign[i].raw);
    state_.known[state_.at] = clear[i];
    if (++state_.at == taps) state_.at = 0;
    signs.add(static_cast<int>(sign[i].raw));
    unknown.add(clear[i] ? 0 : 1);
    passed.put(i, signs.sum());
    clear[i] = !(most_unknown < unknown.sum());
  }
  state_ = at_next;
}

}  // namespace firmware
