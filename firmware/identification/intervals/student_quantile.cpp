#include "firmware/identification/intervals/student_quantile.hpp"

namespace firmware {
namespace {

constexpr int kTableSize = 5;
constexpr int32_t kTable_1e4[kTableSize] = {127062, 43027, 31824, 27764, 25706};  // freedom 1 to 5

Scaled table(int freedom) { return Scaled::ratio(kTable_1e4[freedom - 1], 10000); }

}  // namespace

Scaled student_quantile_95(const Scaled& freedom) {
  if (freedom <= kScaledOne) return table(1);
  if (freedom < Scaled::from_int(kTableSize)) {
    int below = 1;
    while (below + 2 <= kTableSize && Scaled::from_int(below + 1) <= freedom) ++below;
    const Scaled part = freedom - Scaled::from_int(below);
    return table(below) + part * (table(below + 1) - table(below));
  }
  // z + (z^3 + z) / (4 n) + (5 z^5 + 16 z^3 + 3 z) / (96 n^2) + (3 z^7 + 19 z^5 + 17 z^3 - 15 z) / (384 n^3)
  //   + (79 z^9 + 776 z^7 + 1482 z^5 - 1920 z^3 - 945 z) / (92160 n^4), z = 1.959964
  const Scaled inverse = kScaledOne / freedom;
  constexpr int32_t kSeries_1e6[] = {1959964, 2372271, 2822499, 2555852, 1589536};
  Scaled sum;
  for (int power = 4; power >= 0; --power) sum = sum * inverse + Scaled::ratio(kSeries_1e6[power], 1000000);
  return sum;
}

}  // namespace firmware
