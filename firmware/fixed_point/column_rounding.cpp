// From block-floating numbers to a column: once for each column, where its sums take the time.
#include "firmware/fixed_point/whole_column.hpp"
#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {

int32_t round_to_column(const Scaled* numbers, int count, int bits, int32_t* value) {
  report_work(30 * count);
  constexpr int kMantissaBits = 62;
  bool any = false;
  int32_t top = 0;
  for (int b = 0; b < count; ++b) {
    if (numbers[b].is_zero()) continue;
    if (!any || numbers[b].exponent > top) top = numbers[b].exponent;
    any = true;
  }
  for (int b = 0; b < count; ++b) {
    // The upper half of the mantissa holds as many bits as are kept. Below none are dropped of a zero, whatever its exponent.
    const int32_t drop = kMantissaBits - 32 - bits + (top - numbers[b].exponent);
    const int32_t high = static_cast<int32_t>(numbers[b].mantissa >> 32);
    value[b] = drop > 31 ? 0 : drop <= 0 ? high : ((high >> (drop - 1)) + 1) >> 1;
  }
  return top + kMantissaBits - bits;
}

}  // namespace firmware
