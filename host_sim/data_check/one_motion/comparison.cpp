#include "host_sim/data_check/one_motion/comparison.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "host_sim/data_check/one_motion/sides.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kFewestSpans = 30.0;
constexpr double kTurnedCorrelation = -0.6;  // of 30 spans: less than one in 10,000 by chance
constexpr int kDelays = 3;                   // samples that a channel may be late without its sign being in question

using Values = Eigen::Map<const Eigen::ArrayXd>;
Values view(const double* values, size_t count) { return {values, static_cast<Eigen::Index>(count)}; }

struct Moments {
  double pp = 0.0, qq = 0.0, pq = 0.0;
  double correlation() const { return pp > 0.0 && qq > 0.0 ? pq / std::sqrt(pp * qq) : 0.0; }
};

// Of q `lag` samples later, about the means.
Moments moments(const Sides& sides, int lag) {
  const size_t count = sides.from_lower.size(), shift = static_cast<size_t>(std::abs(lag));
  const size_t n = count - shift;
  const Values p = view(sides.from_lower.data() + (lag < 0 ? shift : 0), n);
  const Values q = view(sides.of_upper.data() + (lag > 0 ? shift : 0), n);
  const double mean_p = p.mean(), mean_q = q.mean();
  Moments m;
  m.pp = (p - mean_p).square().sum();
  m.qq = (q - mean_q).square().sum();
  m.pq = ((p - mean_p) * (q - mean_q)).sum();
  return m;
}

// The span where both sides agree best, and their correlation there; 0 where the record is too short to say.
struct BestSpan {
  size_t h = 0;
  double correlation = 0.0;
};
BestSpan best_span(Sides& sides) {
  BestSpan best;
  const double n = static_cast<double>(sides.samples());
  for (size_t h = 1; n / static_cast<double>(2 * h) >= kFewestSpans; h *= 2) {
    sides.here_and_there(h);
    const double r = moments(sides, 0).correlation();
    if (std::abs(r) > std::abs(best.correlation)) best = {h, r};
  }
  return best;
}

// q(t) = g p(t - late): the late part is what q - g p shares with the slope of p.
void measure_lateness(const Sides& sides, double T, size_t h, Comparison& result) {
  double slope_square = 0.0, shared = 0.0, residual = 0.0;
  const size_t n = sides.from_lower.size();
  const double mean_p = view(sides.from_lower.data(), n).mean(), mean_q = view(sides.of_upper.data(), n).mean();
  for (size_t i = 1; i + 1 < n; ++i) {
    const double slope = result.gain * (sides.from_lower[i + 1] - sides.from_lower[i - 1]) / (2.0 * T);
    const double off = sides.of_upper[i] - mean_q - result.gain * (sides.from_lower[i] - mean_p);
    slope_square += slope * slope;
    shared -= off * slope;
    residual += off * off;
  }
  if (!(slope_square > 0.0)) return;
  result.late_s = shared / slope_square;
  residual -= shared * shared / slope_square;
  result.late_std_s =
      std::sqrt(std::max(residual, 0.0) / static_cast<double>(n) * 2.0 * static_cast<double>(h) / slope_square);
}

}  // namespace

double agreement(const Channel& lower, const Channel& upper, double sample_period_s, Integrals& integrals) {
  Sides sides(lower, upper, sample_period_s, integrals);
  return std::abs(best_span(sides).correlation);
}

std::optional<Comparison> compare(const Channel& lower, const Channel& upper, double sample_period_s,
                                  Integrals& integrals) {
  Sides sides(lower, upper, sample_period_s, integrals);
  const BestSpan span = best_span(sides);
  if (span.h == 0) return std::nullopt;
  Comparison best;
  best.lower = lower.quantity;
  best.upper = upper.quantity;
  sides.over(span.h);
  const Moments at_once = moments(sides, 0);
  best.correlation = at_once.correlation();
  best.independent = static_cast<double>(sides.samples()) / static_cast<double>(2 * span.h);
  best.gain = std::copysign(std::sqrt(at_once.qq / at_once.pp), at_once.pq);
  best.turned = best.correlation < kTurnedCorrelation;
  for (int lag = -kDelays; best.turned && lag <= kDelays; ++lag) best.turned = moments(sides, lag).pq < 0.0;
  measure_lateness(sides, sample_period_s, span.h, best);
  return best;
}

}  // namespace host_sim::data_check
