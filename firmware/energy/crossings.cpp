#include "firmware/energy/crossings.hpp"

#include "firmware/fixed_point/precondition.hpp"

namespace firmware {

int64_t crossing_correction_q16(int64_t w0, int64_t w1, int32_t q0, int32_t q1) {
  constexpr int64_t kOne = 1 << 16;
  [[maybe_unused]] constexpr int64_t kLargestRate = int64_t{1} << 35;
  FIRMWARE_PRECONDITION((w0 > 0 && w1 < 0) || (w0 < 0 && w1 > 0));
  FIRMWARE_PRECONDITION(w0 <= kLargestRate && w0 >= -kLargestRate && w1 <= kLargestRate && w1 >= -kLargestRate);
  const int64_t theta = w0 * kOne / (w0 - w1);  // |w| < 2^35: fits; 0 < theta < 2^16
  const int64_t step = static_cast<int64_t>(q1) - q0;
  const int64_t correction = (2 * theta - kOne) * q0 + ((theta * theta) / kOne - kOne / 6) * step;
  return w0 > 0 ? correction : -correction;
}

int64_t crossing_corrections_q16(const int64_t* rate, const int32_t* weight, int from, int to) {
  int64_t sum = 0;
  for (int n = from; n < to; ++n) {
    const bool changes = (rate[n] > 0 && rate[n + 1] < 0) || (rate[n] < 0 && rate[n + 1] > 0);
    if (changes) sum += crossing_correction_q16(rate[n], rate[n + 1], weight[n], weight[n + 1]);
  }
  return sum;
}

}  // namespace firmware
