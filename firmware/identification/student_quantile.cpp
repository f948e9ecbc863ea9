#include "firmware/identification/student_quantile.hpp"

namespace firmware {
namespace {

constexpr int kTableSize = 5;
constexpr int32_t kTable_1e4[kTableSize] = {127062, 43027, 31824, 27764, 25706};  // freedom 1 to 5

Scaled table(int freedom) { return Scaled::ratio(kTable_1e4[freedom - 1], 10000); }

}  // namespace

Scaled student_quantile_95(Scaled freedom) {
  const int64_t whole = to_fixed(freedom, 0);
  if (freedom <= Scaled::from_int(1)) return table(1);
  if (freedom < Scaled::from_int(kTableSize)) {
    int below = static_cast<int>(whole);
    if (Scaled::from_int(below) > freedom) --below;
    const Scaled part = freedom - Scaled::from_int(below);
    return table(below) + part * (table(below + 1) - table(below));
  }
  // z + (z^3 + z) / (4 n) + (5 z^5 + 16 z^3 + 3 z) / (96 n^2) + (3 z^7 + 19 z^5 + 17 z^3 - 15 z) / (384 n^3), z
  // = 1.959964
  const Scaled inverse = Scaled::from_int(1) / freedom;
  return Scaled::ratio(1959964, 1000000) +
         inverse * (Scaled::ratio(2372271, 1000000) +
                    inverse * (Scaled::ratio(2822499, 1000000) + inverse * Scaled::ratio(2555852, 1000000)));
}

}  // namespace firmware
