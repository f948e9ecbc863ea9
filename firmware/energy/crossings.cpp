#include "firmware/energy/crossings.hpp"

#include "firmware/fixed_point/magnitude.hpp"
#include "firmware/fixed_point/precondition.hpp"
#include "firmware/fixed_point/wide.hpp"

namespace firmware {

Crossing crossing_correction(Rate w0, Rate w1, Code q0, Code q1) {
  constexpr int64_t kOne = int64_t{1} << Crossing::kFractionBits;
  [[maybe_unused]] constexpr Rate kLargestRate = Rate::from_raw(int64_t{1} << 35);
  FIRMWARE_PRECONDITION(sign_of(w0) * sign_of(w1) == -1);
  FIRMWARE_PRECONDITION(!(kLargestRate < size_of(w0)) && !(kLargestRate < size_of(w1)));
  const uint64_t size = magnitude(w0.raw), both = size + magnitude(w1.raw);
  // |w| < 2^35: fits; 0 <= theta < 2^16
  const auto theta =
      static_cast<int64_t>(short_quotient(size << Crossing::kFractionBits, both, Crossing::kFractionBits));
  const int64_t step = static_cast<int64_t>(q1.raw) - q0.raw;
  const int64_t correction = (2 * theta - kOne) * q0.raw + ((theta * theta) / kOne - kOne / 6) * step;
  return Crossing::from_raw(w0.raw > 0 ? correction : -correction);
}

Crossing crossing_corrections(const Rate* rate, ConstColumn<Code> weight, int from, int to) {
  Crossing sum;
  for (int n = from; n < to; ++n)
    if (sign_of(rate[n]) * sign_of(rate[n + 1]) < 0)
      sum = sum + crossing_correction(rate[n], rate[n + 1], weight[n], weight[n + 1]);
  return sum;
}

}  // namespace firmware
