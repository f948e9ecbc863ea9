#include "firmware/links/high_passed_sign.hpp"

namespace firmware {
namespace {
constexpr int kStateFraction = 16;
}  // namespace

void HighPassedSign::fill(int order, int shift, int from, int to, int advance, int32_t* sign) {
  State at_next = state_;
  for (int i = from; i < to; ++i) {
    if (i == from + advance) at_next = state_;
    int64_t value = sign[i] * (int64_t{1} << (kFilteredSignBits + kStateFraction));
    if (!state_.started) state_.previous[0] = value;  // it has stood there for ever
    state_.started = true;
    for (int s = 0; s < order; ++s) {
      state_.section[s] += value - state_.previous[s] - (state_.section[s] >> shift);
      state_.previous[s] = value;
      value = state_.section[s];
    }
    sign[i] = static_cast<int32_t>((value + (int64_t{1} << (kStateFraction - 1))) >> kStateFraction);
  }
  state_ = at_next;
}

}  // namespace firmware
