#include "period.hpp"

#include <algorithm>
#include <cmath>

#include "../band/band.hpp"
#include "guess.hpp"

namespace diagnosis::runs {
namespace {

// Of the slowest that is kept: it loses nothing of it, and two thirds of what is half as fast.
constexpr double kSlowPeriods = 1;
constexpr double kMostlySlow = 0.5;  // of the square of a velocity about its mean

// What an integral without its drift does not hold is slower than that: of a shaft that runs down all there is. Its period is that of a
// decay with the same slope.
double slow_period(const Vec& v, const Drift& drift, double step_s) {
  const Vec slow = v - without_drift(v, drift);
  const double about = rms_about_mean(slow), whole = rms_about_mean(v);
  if (!(about * about > kMostlySlow * whole * whole)) return 0;
  const Index n = slow.size();
  const double slope =
      std::sqrt((slow.tail(n - 1) - slow.head(n - 1)).squaredNorm() / static_cast<double>(n - 1)) / step_s;
  return slope > 0 ? kTwoPi * about / slope : 0;
}

}  // namespace

// What is slower is noise that integration raises: of a decay of one frequency it was the larger part of the displacement.
double slow_s(const Prepared& p) {
  double longest = 0;
  for (const MotionTrace& t : p.traces) {
    if (trace_of(p, t.dof, 0) || (t.quantity == 2 && trace_of(p, t.dof, 1))) continue;
    longest = std::max(longest, kSlowPeriods / slowest_above_noise(t.y, p.step_s, t.quantity));
  }
  return longest > 0 ? longest : 1e300;
}

double period_of(const Prepared& p) {
  double longest = 0;
  for (size_t i = 0; i < p.guess.size(); ++i) {
    const Guess& g = p.guess[i];
    if (!g.given) continue;
    const int dof = static_cast<int>(i);
    const MotionTrace* place = trace_of(p, dof, 0);
    const double v = rms_about_mean(g.v);
    const double x = place && place->travels ? std::sqrt(square_off_line(g.x) / static_cast<double>(g.x.size()))
                                             : rms_about_mean(g.x);
    if (v > 0) longest = std::max(longest, kTwoPi * x / v);
    if (!place && trace_of(p, dof, 1)) longest = std::max(longest, slow_period(g.v, {p.slow_half}, p.step_s));
  }
  return longest;
}

}  // namespace diagnosis::runs
