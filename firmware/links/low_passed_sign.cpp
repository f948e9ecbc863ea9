#include "firmware/links/low_passed_sign.hpp"

namespace firmware {
namespace {
constexpr int32_t kMostUnknown = (1 << kFilteredSignBits) / 4;
}  // namespace

void LowPassedSign::fill(const CoreConfiguration& configuration, int from, int to, int advance, int32_t* sign,
                         int32_t* clear) {
  const int taps = 2 * configuration.sign_half_length + 1;
  State at_next = state_;
  for (int i = from; i < to; ++i) {
    if (i == from + advance) at_next = state_;
    state_.sign[state_.at] = static_cast<int8_t>(sign[i]);
    state_.known[state_.at] = clear[i] != 0;
    if (++state_.at == taps) state_.at = 0;
    int32_t sum = 0, unknown = 0;
    int at = state_.at;  // the oldest
    for (int k = 0; k < taps; ++k) {
      const int32_t tap = configuration.sign_tap[k].raw;
      sum += state_.sign[at] * tap;
      if (!state_.known[at]) unknown += tap < 0 ? -tap : tap;
      if (++at == taps) at = 0;
    }
    sign[i] = sum;
    clear[i] = unknown > kMostUnknown ? 0 : 1;
  }
  state_ = at_next;
}

}  // namespace firmware
