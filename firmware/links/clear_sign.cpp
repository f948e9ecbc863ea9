#include "firmware/links/clear_sign.hpp"

namespace firmware {
namespace {

constexpr int kSlowShareLog2 = 3;

int64_t magnitude(int64_t x) { return x < 0 ? -x : x; }
int32_t sign_of(int64_t x) { return static_cast<int32_t>(x > 0) - static_cast<int32_t>(x < 0); }

}  // namespace

void ClearSign::configure(const RateGains& gains, int means, bool slow) {
  gains_ = gains;
  means_ = means;
  slow_ = slow;
}

void ClearSign::restart() { known_ = Known{}; }

int32_t ClearSign::judge(int64_t own, int64_t around) {
  known_.differences += magnitude(6 * own - around);
  known_.magnitudes += magnitude(6 * own);
  if (++known_.count == kLongMemory) {
    known_.differences /= 2;
    known_.magnitudes /= 2;
    known_.count /= 2;
  }
  const int64_t doubt = means_ * known_.differences + (slow_ ? known_.magnitudes >> kSlowShareLog2 : 0);
  const bool clear = magnitude(around) * known_.count > doubt && sign_of(own) == sign_of(around);
  return clear ? sign_of(around) : 0;
}

void ClearSign::fill(const Frame& frame, int from, int to, int advance, int32_t* clear, int32_t* sign) {
  int64_t w[kFrameStride];
  link_rate(gains_, frame, false, from - 2, to + 2, w);
  Known at_next = known_;
  for (int i = from; i < to; ++i) {
    if (i == from + advance) at_next = known_;
    clear[i] = judge(w[i], 4 * (w[i - 1] + w[i + 1]) - w[i - 2] - w[i + 2]);
    sign[i] = sign_of(w[i]);
  }
  known_ = at_next;
}

}  // namespace firmware
