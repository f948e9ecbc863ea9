#include "host_sim/plant/instruments/signal.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <limits>
#include <utility>

#include "host_sim/plant/instruments/line_sum.hpp"
#include "host_sim/plant/instruments/random_numbers.hpp"

namespace host_sim {
namespace {

constexpr double kTwoPi = 6.283185307179586476925;
constexpr double kForEver = std::numeric_limits<double>::infinity();
constexpr double kNearKnot = 1e-9;  // of a period: a time this near before a knot is taken for the knot's

// The knot that a time lies behind, and how far: position in periods since the first knot; count knots. -1: before the first.
double knot_before(double position, size_t count) {
  return std::clamp(std::floor(position + kNearKnot), -1.0, static_cast<double>(count - 1));
}

// c[k] theta^k, k below count, of p0 .. p5 s^j with s = from + ratio theta.
int shifted(const double (&p)[6], double from, double ratio, int count, double* c) {
  double shift[6];
  std::copy(std::begin(p), std::end(p), shift);
  for (int k = 0; k < 5; ++k)
    for (int j = 4; j >= k; --j) shift[j] += from * shift[j + 1];
  double power = 1.0;
  for (int k = 0; k < count; ++k, power *= ratio) c[k] = k < 6 ? shift[k] * power : 0.0;
  return std::min(count, 6);
}

class Cosine : public Signal {
 public:
  Cosine(double amplitude, double frequency_Hz, double phase_rad)
      : amplitude_(amplitude), omega_(kTwoPi * frequency_Hz), phase_(phase_rad) {}
  double value(double t) const override { return amplitude_ * std::cos(omega_ * t + phase_); }
  Motion motion(double t) const override {
    const double c = amplitude_ * std::cos(omega_ * t + phase_), s = amplitude_ * std::sin(omega_ * t + phase_);
    return {c, -omega_ * s, -omega_ * omega_ * c};
  }
  double smooth_until(double) const override { return kForEver; }
  // a cos(phi + w theta): derivatives cos, -sin, -cos, sin, w = omega step.
  int expand(double t, double step, int count, double* series) const override {
    const double c = std::cos(omega_ * t + phase_), s = std::sin(omega_ * t + phase_), turn[4] = {c, -s, -c, s};
    double factor = amplitude_;
    for (int k = 0; k < count; factor *= omega_ * step / (k + 1), ++k) series[k] = factor * turn[k % 4];
    return count;
  }
  double peak() const override { return std::fabs(amplitude_); }

 private:
  double amplitude_, omega_, phase_;
};

// Piecewise quintic through values with two derivatives at every knot.
class Quintic : public Signal {
 public:
  Quintic(std::vector<Motion> knots, double start, double period)
      : knots_(std::move(knots)), start_(start), period_(period) {
    for (const Motion& knot : knots_) peak_ = std::max(peak_, std::fabs(knot.value));
  }
  double value(double t) const override {
    SignalPiece piece;
    return piece_at(t, piece) ? piece.value((t - start_) / period_) : motion(t).value;
  }
  bool piece_at(double t, SignalPiece& piece) const override {
    const double position = (t - start_) / period_;
    const size_t k = static_cast<size_t>(std::max(0.0, position));
    if (position <= 0.0 || k + 1 >= knots_.size()) return false;
    const Motion &p = knots_[k], &q = knots_[k + 1];
    const double h = period_, p1 = p.rate * h, p2 = 0.5 * p.acceleration * h * h;
    const double d0 = q.value - p.value - p1 - p2, d1 = q.rate * h - p1 - 2.0 * p2,
                 d2 = 0.5 * q.acceleration * h * h - p2;
    piece = {start_,
             period_,
             static_cast<double>(k),
             {p.value, p1, p2, 10.0 * d0 - 4.0 * d1 + d2, -15.0 * d0 + 7.0 * d1 - 2.0 * d2, 6.0 * d0 - 3.0 * d1 + d2}};
    return true;
  }
  double smooth_until(double t) const override {
    const double knot = knot_before((t - start_) / period_, knots_.size());
    return knot + 1.0 < static_cast<double>(knots_.size()) ? start_ + (knot + 1.0) * period_ : kForEver;
  }
  int expand(double t, double step, int count, double* c) const override {
    const double position = (t - start_) / period_, knot = knot_before(position, knots_.size());
    SignalPiece piece;
    if (!piece_at(start_ + (knot + 0.5) * period_, piece))
      piece.c[0] = knot < 0.0 ? knots_.front().value : knots_.back().value;
    return shifted(piece.c, position - knot, step / period_, count, c);
  }
  double peak() const override { return peak_; }
  Motion motion(double t) const override {
    const double position = (t - start_) / period_;
    const double last = static_cast<double>(knots_.size() - 1);
    if (position <= 0.0) return position < 0.0 ? Motion{knots_.front().value, 0.0, 0.0} : knots_.front();
    if (position >= last) return position > last ? Motion{knots_.back().value, 0.0, 0.0} : knots_.back();
    const size_t k = static_cast<size_t>(position);
    return between(knots_[k], knots_[k + 1], position - static_cast<double>(k));
  }

 private:
  // c0 .. c5 of the polynomial in s = (t - t_k) / period
  Motion between(const Motion& p, const Motion& q, double s) const {
    const double h = period_, p1 = p.rate * h, p2 = 0.5 * p.acceleration * h * h;
    const double d0 = q.value - p.value - p1 - p2, d1 = q.rate * h - p1 - 2.0 * p2,
                 d2 = q.acceleration * h * h - 2.0 * p2;
    const double c3 = 10.0 * d0 - 4.0 * d1 + 0.5 * d2, c4 = -15.0 * d0 + 7.0 * d1 - d2,
                 c5 = 6.0 * d0 - 3.0 * d1 + 0.5 * d2;
    Motion m;
    m.value = p.value + s * (p1 + s * (p2 + s * (c3 + s * (c4 + s * c5))));
    m.rate = (p1 + s * (2.0 * p2 + s * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5)))) / h;
    m.acceleration = (2.0 * p2 + s * (6.0 * c3 + s * (12.0 * c4 + s * 20.0 * c5))) / (h * h);
    return m;
  }
  std::vector<Motion> knots_;
  double start_, period_, peak_ = 0.0;
};

class Linear : public Signal {
 public:
  Linear(std::vector<double> values, double start, double period)
      : values_(std::move(values)), start_(start), period_(period) {
    for (double v : values_) peak_ = std::max(peak_, std::fabs(v));
  }
  double value(double t) const override { return motion(t).value; }
  double peak() const override { return peak_; }
  Motion motion(double t) const override {
    const double position = std::max(0.0, (t - start_) / period_);
    const size_t k = std::min(static_cast<size_t>(position), values_.size() - 1);
    if (k + 1 == values_.size()) return {values_[k], 0.0, 0.0};
    const double slope = values_[k + 1] - values_[k];
    return {values_[k] + slope * (position - static_cast<double>(k)), slope / period_, 0.0};
  }
  double smooth_until(double t) const override {
    const double knot = knot_before((t - start_) / period_, values_.size());
    return knot + 1.0 < static_cast<double>(values_.size()) ? start_ + (knot + 1.0) * period_ : kForEver;
  }
  int expand(double t, double step, int count, double* c) const override {
    const double position = (t - start_) / period_, knot = knot_before(position, values_.size());
    const size_t k = static_cast<size_t>(std::max(0.0, knot));
    const double slope = knot < 0.0 || k + 1 == values_.size() ? 0.0 : values_[k + 1] - values_[k];
    const double piece[6] = {values_[k], slope};
    return shifted(piece, position - knot, step / period_, count, c);
  }

 private:
  std::vector<double> values_;
  double start_, period_;
  double peak_ = 0.0;
};

// Central difference weights for the first and second derivative, half-width 1 to 4 (orders 2 to 8).
constexpr double kFirst[4][4] = {{1.0 / 2, 0, 0, 0},
                                 {2.0 / 3, -1.0 / 12, 0, 0},
                                 {3.0 / 4, -3.0 / 20, 1.0 / 60, 0},
                                 {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280}};
constexpr double kSecond[4][4] = {{1.0, 0, 0, 0},
                                  {4.0 / 3, -1.0 / 12, 0, 0},
                                  {3.0 / 2, -3.0 / 20, 1.0 / 90, 0},
                                  {8.0 / 5, -1.0 / 5, 8.0 / 315, -1.0 / 560}};

std::vector<Motion> with_derivatives(const std::vector<double>& f, double h) {
  std::vector<Motion> knots(f.size());
  for (size_t k = 0; k < f.size(); ++k) {
    knots[k].value = f[k];
    const size_t room = std::min({k, f.size() - 1 - k, size_t{4}});
    for (size_t j = 1; j <= room; ++j) {
      knots[k].rate += kFirst[room - 1][j - 1] * (f[k + j] - f[k - j]) / h;
      knots[k].acceleration += kSecond[room - 1][j - 1] * ((f[k + j] - f[k]) + (f[k - j] - f[k])) / (h * h);
    }
  }
  if (f.size() >= 3) {  // ends: the parabola through three samples
    const size_t n = f.size() - 1;
    knots[0].rate = (-1.5 * f[0] + 2.0 * f[1] - 0.5 * f[2]) / h;
    knots[n].rate = (1.5 * f[n] - 2.0 * f[n - 1] + 0.5 * f[n - 2]) / h;
    knots[0].acceleration = knots[1].acceleration;
    knots[n].acceleration = knots[n - 1].acceleration;
  } else if (f.size() == 2) {
    knots[0].rate = knots[1].rate = (f[1] - f[0]) / h;
  }
  return knots;
}

}  // namespace

SignalPtr cosine(double amplitude, double frequency_Hz, double phase_rad) {
  return std::make_shared<Cosine>(amplitude, frequency_Hz, phase_rad);
}

SignalPtr random_band(const RandomBand& band, double start_s, double end_s, double table_step_s, uint64_t seed,
                      uint64_t stream) {
  const size_t count = static_cast<size_t>(std::ceil((end_s - start_s) / table_step_s)) + 2;
  const double line_Hz = 1.0 / (static_cast<double>(count) * table_step_s);
  const size_t lines = std::max<size_t>(1, static_cast<size_t>((band.high_Hz - band.low_Hz) / line_Hz));
  const double spacing_Hz = (band.high_Hz - band.low_Hz) / static_cast<double>(lines);
  const double amplitude = band.rms * std::sqrt(2.0 / static_cast<double>(lines));
  RandomNumbers random(seed, stream);
  const auto line_frequency_Hz = [&](size_t k) { return band.low_Hz + (static_cast<double>(k) + 0.5) * spacing_Hz; };
  std::vector<std::complex<double>> line(lines);
  for (std::complex<double>& phasor : line) phasor = std::polar(amplitude, kTwoPi * random.uniform());
  const LineSum sum(lines, count, line_frequency_Hz(0) * table_step_s, spacing_Hz * table_step_s);
  std::vector<Motion> knots(count);
  const auto next_derivative = [&] {
    for (size_t k = 0; k < lines; ++k) line[k] *= std::complex<double>(0.0, kTwoPi * line_frequency_Hz(k));
  };
  for (double Motion::*derivative : {&Motion::value, &Motion::rate, &Motion::acceleration}) {
    const std::vector<std::complex<double>> at_knots = sum.of(line);
    for (size_t n = 0; n < count; ++n) knots[n].*derivative = at_knots[n].real();
    next_derivative();
  }
  return std::make_shared<Quintic>(std::move(knots), start_s, table_step_s);
}

SignalPtr sampled(std::vector<double> values, double start_s, double period_s, Interpolation interpolation) {
  if (values.empty()) values.push_back(0.0);
  if (interpolation == Interpolation::kQuintic)
    return std::make_shared<Quintic>(with_derivatives(values, period_s), start_s, period_s);
  return std::make_shared<Linear>(std::move(values), start_s, period_s);
}

}  // namespace host_sim
