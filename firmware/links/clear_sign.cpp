#include "firmware/links/clear_sign.hpp"

namespace firmware {
namespace {

// Mean differences between a rate and its neighbours that are beyond doubt. Half of a derived rate's noise and more is slower.
constexpr int kMeansMeasured = 4, kMeansDerived = 8;
constexpr int kSlowShareLog2 = 3;
// Noise of deviation s takes s^2 / (2 A^2) from the friction of a rate that is A rms. Mean rates over three deviations are motion:
// then that is 4 % of what is counted there, and that is the least that counts.
constexpr int kMovingPercent = 300;
constexpr int kNearLog2 = 6;
constexpr int64_t kMostRate = int64_t{1} << 44;

}  // namespace

void ClearSign::configure(const RateGains& gains, bool measured, bool slow, const Scaled& noise) {
  gains_ = gains;
  known_.measured = measured;
  known_.slow = slow;
  if (!kDerivesSignals) return;
  const int64_t least = to_fixed(noise * Scaled::ratio((6 << kNearLog2) * kMovingPercent, 100), Rate::kFractionBits);
  least_ = Rate::from_raw(least < kMostRate ? least : kMostRate);
}

void ClearSign::restart() {
  Known fresh;
  fresh.measured = known_.measured;
  fresh.slow = known_.slow;
  known_ = fresh;
}

template <typename Number>
bool ClearSign::judge(Known& known, Number own, Number around) const {
  // Where no rate is derived all are measured.
  const bool measured = !kDerivesSignals || known.measured, slow = kDerivesSignals && known.slow;
  known.differences = known.differences + rescale<Rate>(size_of(6 * own - around));
  if (slow) known.magnitudes = known.magnitudes + rescale<Rate>(size_of(6 * own));
  if (++known.count == kLongMemory) {
    known.differences = known.differences >> 1;
    if (slow) known.magnitudes = known.magnitudes >> 1;
    known.count /= 2;
  }
  if (kDerivesSignals && Rate{} < least_) {
    known.near = known.near + rescale<Rate>(size_of(6 * own)) - (known.near >> kNearLog2);
    if (known.near < (measured ? least_ + least_ : least_)) return false;
    if (measured && rescale<Rate>(size_of(6 * own)) < (least_ >> kNearLog2)) return false;
  }
  if (sign_of(own) != sign_of(around)) return false;
  const Rate size = rescale<Rate>(size_of(around));
  const int means = measured ? kMeansMeasured : kMeansDerived;
  const Rate doubt = means * known.differences + (slow ? known.magnitudes >> kSlowShareLog2 : Rate{});
  return doubt < static_cast<int32_t>(known.count) * size;
}

template <typename Number>
void ClearSign::judge_block(const Number* w, int from, int to, int advance, bool* clear, Column<Code> sign) {
  const int next = from + advance;  // what is behind it comes again at the next call
  Known known = known_;
  for (int i = from; i < to; ++i) {
    if (i == next) known_ = known;
    clear[i] = judge(known, w[i], 4 * (w[i - 1] + w[i + 1]) - w[i - 2] - w[i + 2]);
    sign.put(i, Code::from_raw(sign_of(w[i])));
  }
  if (next >= to) known_ = known;
}

// Where both nodes have one unit the rate is a plain difference of codes: 25 bits, 29 around it.
void ClearSign::fill(const Frame& frame, int from, int to, int advance, bool* clear, Column<Code> sign) {
  if (equal_units(gains_)) {
    Code w[kFrameStride];
    rate_of_difference(gains_, frame, from - 2, to + 2, w);
    return judge_block(w, from, to, advance, clear, sign);
  }
  Rate w[kFrameStride];
  link_rate(gains_, frame, false, from - 2, to + 2, w);
  judge_block(w, from, to, advance, clear, sign);
}

}  // namespace firmware
