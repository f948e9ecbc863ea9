#include "host_sim/programs/estimate/delay_or_corner.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace host_sim {
namespace {

// A delay that a high-pass may stand for is told from it by four deviations; a high-pass beside a delay shows from two on, which chance
// makes in one of 20 records: it costs a correction then, and no number is wrong for it.
constexpr double kNeeded = 4.0, kNotNeeded = 2.0;
// Of what the delay explains, in amplitude. Less is what a series and sums of samples leave of a delay: 0.15 of one of a whole sample.
constexpr double kMattersShare = 0.3;
// Of the delay's column, what gain and high-pass cannot make: that of two tones of one strength a factor of 1.45 apart.
constexpr double kOwnShare = 0.125;
constexpr size_t kParts = 16, kFewestSamples = 16 * kParts;

// The acceleration as g times the displacement's side, its slope, less wc times its own integral, and what a sensor's zero makes of that
// integral: a parabola. Of one tone and its harmonics slope and integral are the same.
enum Column { kGain, kDelay, kCorner, kOne, kTime, kSquare, kColumns };
using Row = Eigen::Matrix<double, kColumns, 1>;
using Square = Eigen::Matrix<double, kColumns, kColumns>;

}  // namespace

void DelayAndCorner::Mean::add(double value, double variance) {
  if (!(variance > 0.0) || !std::isfinite(value)) return;
  sum += value / variance;
  weight += 1.0 / variance;
}

double DelayAndCorner::Mean::deviations() const { return weight > 0.0 ? std::abs(sum) / std::sqrt(weight) : 0.0; }

// Least squares; the deviations from the scatter of sixteen parts of the record.
void DelayAndCorner::add(const std::vector<double>& of_x, const std::vector<double>& of_a, double sample_period_s) {
  const size_t n = of_x.size();
  if (n < kFewestSamples) return;
  std::vector<Row> rows(n, Row::Zero());
  double integral = 0.0;
  for (size_t i = 1; i + 1 < n; ++i) {
    integral += 0.5 * sample_period_s * (of_a[i - 1] + of_a[i]);
    const double t = 2.0 * static_cast<double>(i) / static_cast<double>(n) - 1.0;
    rows[i] << of_x[i], (of_x[i + 1] - of_x[i - 1]) / (2.0 * sample_period_s), integral, 1.0, t, t * t;
  }
  Square normal = Square::Zero();
  Row right = Row::Zero();
  for (size_t i = 1; i + 1 < n; ++i) normal += rows[i] * rows[i].transpose(), right += rows[i] * of_a[i];
  const Row scale = normal.diagonal().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return;
  const Square inverse =
      scale.asDiagonal() * (scale.asDiagonal() * normal * scale.asDiagonal()).inverse() * scale.asDiagonal();
  if (!(1.0 > kOwnShare * inverse(kDelay, kDelay) * normal(kDelay, kDelay))) return;
  const Row fit = inverse * right;
  Square scatter = Square::Zero();
  for (size_t part = 0; part < kParts; ++part) {
    Row score = Row::Zero();
    for (size_t i = part * n / kParts; i < (part + 1) * n / kParts; ++i)
      if (i > 0 && i + 1 < n) score += rows[i] * (of_a[i] - rows[i].dot(fit));
    scatter += score * score.transpose();
  }
  const Square covariance = inverse * scatter * inverse;
  if (!fit.allFinite() || !covariance.allFinite()) return;
  late_s_.add(-fit[kDelay] / fit[kGain], covariance(kDelay, kDelay) / (fit[kGain] * fit[kGain]));
  corner_.add(-fit[kCorner], covariance(kCorner, kCorner));
  delay_square_ += fit[kDelay] * fit[kDelay] / inverse(kDelay, kDelay);
  corner_square_ += fit[kCorner] * fit[kCorner] / inverse(kCorner, kCorner);
}

bool DelayAndCorner::is_a_delay() const {
  const bool matters = corner_square_ > kMattersShare * kMattersShare * delay_square_;
  return late_s_.deviations() > kNeeded && !(matters && corner_.deviations() > kNotNeeded);
}

}  // namespace host_sim
