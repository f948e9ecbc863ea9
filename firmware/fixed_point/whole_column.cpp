#include "firmware/fixed_point/whole_column.hpp"

#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {

Scaled dot(WholeColumn a, WholeColumn b, int count) {
  report_work(100 + 5 * count);
  int64_t sum = 0;
  for (int i = 0; i < count; ++i) sum += static_cast<int64_t>(a.value[i]) * b.value[i];
  return Scaled::from_int(sum, a.exponent + b.exponent);
}

void add_columns(const int32_t* const* column, const int32_t* factor, int terms, int count, int32_t* target) {
  for (int b = 0; b < count; ++b) {
    report_work(14 + 9 * terms);
    int64_t sum = int64_t{1} << (kColumnFactorBits - 1);
    for (int s = 0; s < terms; ++s) sum += static_cast<int64_t>(factor[s]) * column[s][b];
    target[b] = static_cast<int32_t>(sum >> kColumnFactorBits);
  }
}

}  // namespace firmware
