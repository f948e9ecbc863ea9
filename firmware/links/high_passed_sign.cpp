#include "firmware/links/high_passed_sign.hpp"

namespace firmware {

void HighPassedSign::fill(int order, int shift, int from, int to, int advance, Column<PassedSign> sign) {
  State at_next = state_;
  for (int i = from; i < to; ++i) {
    if (i == from + advance) at_next = state_;
    Section value = rescale<Section>(sign[i]);
    if (!state_.started) state_.previous[0] = value;  // it has stood there for ever
    state_.started = true;
    for (int s = 0; s < order; ++s) {
      state_.section[s] = state_.section[s] + (value - state_.previous[s] - (state_.section[s] >> shift));
      state_.previous[s] = value;
      value = state_.section[s];
    }
    sign.put(i, rescale<PassedSign>(value));
  }
  state_ = at_next;
}

}  // namespace firmware
