#include "fault_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis::runs {

Vec slope_in_time(const Vec& row, double step_s) {
  const Index n = row.size();
  Vec out(n);
  for (Index i = 0; i < n; ++i) {
    if (i >= 2 && i + 2 < n)
      out[i] = (8 * (row[i + 1] - row[i - 1]) - (row[i + 2] - row[i - 2])) / (12 * step_s);
    else {
      const Index a = std::max<Index>(0, i - 1), b = std::min(n - 1, i + 1);
      out[i] = (row[b] - row[a]) / (static_cast<double>(b - a) * step_s);
    }
  }
  return out;
}

Vec hum_wave(const Prepared& record, Index from, Index length, double frequency_Hz, bool cosine) {
  Vec out(length);
  for (Index k = 0; k < length; ++k) {
    const double angle = kTwoPi * frequency_Hz * record.time_s(from + k);
    out[k] = cosine ? std::cos(angle) : std::sin(angle);
  }
  return out;
}

}  // namespace diagnosis::runs
