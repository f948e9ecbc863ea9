#include "firmware/links/clear_sign.hpp"

namespace firmware {
namespace {

constexpr int kSlowShareLog2 = 3;

template <typename Rate>
Rate magnitude(Rate x) {
  return x < 0 ? -x : x;
}
template <typename Rate>
int32_t sign_of(Rate x) {
  return static_cast<int32_t>(x > 0) - static_cast<int32_t>(x < 0);
}

}  // namespace

void ClearSign::configure(const RateGains& gains, int means, bool slow) {
  gains_ = gains;
  means_ = means;
  slow_ = slow;
}

void ClearSign::restart() { known_ = Known{}; }

template <int kUnitBits, typename Rate>
int32_t ClearSign::judge(Rate own, Rate around) {
  constexpr int64_t kUnit = int64_t{1} << kUnitBits;
  known_.differences += magnitude(6 * own - around) * kUnit;
  if (slow_) known_.magnitudes += magnitude(6 * own) * kUnit;
  if (++known_.count == kLongMemory) {
    known_.differences /= 2;
    known_.magnitudes /= 2;
    known_.count /= 2;
  }
  if (sign_of(own) != sign_of(around)) return 0;
  const int64_t doubt = means_ * known_.differences + (slow_ ? known_.magnitudes >> kSlowShareLog2 : 0);
  return magnitude(around) * (kUnit * known_.count) > doubt ? sign_of(around) : 0;
}

template <int kUnitBits, typename Rate>
void ClearSign::judge_block(const Rate* w, int from, int to, int advance, int32_t* clear, int32_t* sign) {
  const int next = from + advance < to ? from + advance : to;
  for (int i = from; i < next; ++i) {
    clear[i] = judge<kUnitBits>(w[i], static_cast<Rate>(4 * (w[i - 1] + w[i + 1]) - w[i - 2] - w[i + 2]));
    sign[i] = sign_of(w[i]);
  }
  const Known at_next = known_;
  for (int i = next; i < to; ++i) {  // comes again at the next call
    clear[i] = judge<kUnitBits>(w[i], static_cast<Rate>(4 * (w[i - 1] + w[i + 1]) - w[i - 2] - w[i + 2]));
    sign[i] = sign_of(w[i]);
  }
  known_ = at_next;
}

// Where both nodes have one unit the rate is a plain difference, times a power of two: 25 bits, 29 around it.
void ClearSign::fill(const Frame& frame, int from, int to, int advance, int32_t* clear, int32_t* sign) {
  if (equal_units(gains_)) {
    int32_t w[kFrameStride];
    rate_of_difference(gains_, frame, from - 2, to + 2, w);
    return judge_block<kRateGuardBits>(w, from, to, advance, clear, sign);
  }
  int64_t w[kFrameStride];
  link_rate(gains_, frame, false, from - 2, to + 2, w);
  judge_block<0>(w, from, to, advance, clear, sign);
}

}  // namespace firmware
