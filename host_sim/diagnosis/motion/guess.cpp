#include "guess.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

// Sums of the second, fourth and sixth powers of -half ... half.
struct Powers {
  double s2 = 0, s4 = 0, s6 = 0;
};
Powers powers_over(Index half) {
  Powers p;
  for (Index i = -half; i <= half; ++i) {
    const double q = static_cast<double>(i * i);
    p.s2 += q, p.s4 += q * q, p.s6 += q * q * q;
  }
  return p;
}

// Local cubic over 2 half + 1 samples: value and slope of the record (Savitzky and Golay).
void smooth_cubic(const Vec& y, Index half, double step_s, Vec* value, Vec* slope) {
  const Index n = y.size();
  const auto [s2, s4, s6] = powers_over(half);
  const double s0 = static_cast<double>(2 * half + 1), d0 = s0 * s4 - s2 * s2, d1 = s2 * s6 - s4 * s4;
  if (value) value->resize(n);
  if (slope) slope->resize(n);
  for (Index c = 0; c < n; ++c) {
    const Index m = std::clamp(c, half, n - 1 - half);
    double a0 = 0, a1 = 0, a2 = 0, a3 = 0;
    for (Index i = -half; i <= half; ++i) {
      const double t = static_cast<double>(i), q = t * t, f = y[m + i];
      a0 += f * (s4 - s2 * q) / d0, a2 += f * (s0 * q - s2) / d0;
      a1 += f * t * (s6 - s4 * q) / d1, a3 += f * t * (s2 * q - s4) / d1;
    }
    const double t = static_cast<double>(c - m);
    if (value) (*value)[c] = a0 + t * (a1 + t * (a2 + t * a3));
    if (slope) (*slope)[c] = (a1 + t * (2 * a2 + 3 * t * a3)) / step_s;
  }
}

// The straight line that fits a stretch best, at one of its samples.
double line_at(const Vec& y, Index from, Index count, Index at) {
  const double middle = 0.5 * static_cast<double>(count - 1), n = static_cast<double>(count);
  double slope = 0;
  for (Index i = 0; i < count; ++i) slope += (static_cast<double>(i) - middle) * y[from + i];
  slope /= std::max(1.0, n * (n * n - 1) / 12);
  return y.segment(from, count).mean() + slope * (static_cast<double>(at - from) - middle);
}

// A moving mean, at the ends a straight line.
Vec slow_part(const Vec& z, Index slow) {
  Vec sums(z.size() + 1);
  sums[0] = 0;
  for (Index i = 0; i < z.size(); ++i) sums[i + 1] = sums[i] + z[i];
  const Index n = z.size(), half = std::max<Index>(1, std::min(slow, (n - 1) / 2)), whole = 2 * half + 1;
  Vec out(n);
  for (Index i = half; i + half < n; ++i) out[i] = (sums[i + half + 1] - sums[i - half]) / static_cast<double>(whole);
  const double first = line_at(z, 0, whole, 0), last = line_at(z, n - whole, whole, n - 1);
  const double inner = line_at(z, 0, whole, half), outer = line_at(z, n - whole, whole, n - 1 - half);
  for (Index i = 0; i < half; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(half);
    out[i] = first + share * (inner - first), out[n - 1 - i] = last + share * (outer - last);
  }
  return out;
}

}  // namespace

Vec without_drift(const Vec& z, const Drift& drift) {
  Vec slow = z;
  for (int pass = 0; pass < drift.passes; ++pass) slow = slow_part(slow, drift.half);
  return z - slow;
}

double slope_noise(Index half, double step_s) {
  const Powers p = powers_over(half);
  return std::sqrt(p.s6 / (p.s2 * p.s6 - p.s4 * p.s4)) / step_s;
}

Guess guess_of(const std::vector<const Vec*>& measured, double step_s, Index half, const Drift& drift) {
  Guess g;
  g.given = true;
  if (measured[0]) {
    smooth_cubic(*measured[0], half, step_s, &g.x, &g.v);
  }
  if (measured[1]) {
    smooth_cubic(*measured[1], half, step_s, &g.v, &g.a);
    if (!measured[0]) g.x = without_drift(integral(*measured[1], step_s), drift);
  }
  if (measured[2]) {
    g.a = *measured[2];
    if (!measured[0] && !measured[1]) {
      g.v = without_drift(integral(Vec(g.a.array() - g.a.mean()), step_s), drift);
      g.x = without_drift(integral(g.v, step_s), drift);
    }
  }
  if (g.a.size() == 0) smooth_cubic(g.v, half, step_s, nullptr, &g.a);
  return g;
}

}  // namespace diagnosis::runs
