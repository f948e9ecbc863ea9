#include "firmware/links/low_passed_sign.hpp"

namespace firmware {
namespace {
constexpr PassedSign kMostUnknown = PassedSign::from_raw((1 << PassedSign::kFractionBits) / 4);
}  // namespace

void LowPassedSign::fill(const CoreConfiguration& configuration, int from, int to, int advance, Column<Code> sign,
                         Column<PassedSign> passed, bool* clear) {
  const int taps = 2 * configuration.sign_half_length + 1;
  State at_next = state_;
  for (int i = from; i < to; ++i) {
    if (i == from + advance) at_next = state_;
    state_.sign[state_.at] = static_cast<int8_t>(sign[i].raw);
    state_.known[state_.at] = clear[i];
    if (++state_.at == taps) state_.at = 0;
    PassedSign sum, unknown;
    int at = state_.at;  // the oldest
    for (int k = 0; k < taps; ++k) {
      const PassedSign tap = configuration.sign_tap[k];
      sum = sum + state_.sign[at] * tap;
      if (!state_.known[at]) unknown = unknown + size_of(tap);
      if (++at == taps) at = 0;
    }
    passed.put(i, sum);
    clear[i] = !(kMostUnknown < unknown);
  }
  state_ = at_next;
}

}  // namespace firmware
