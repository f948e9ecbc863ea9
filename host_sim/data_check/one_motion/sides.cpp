#include "host_sim/data_check/one_motion/sides.hpp"

#include <algorithm>

namespace host_sim::data_check {
namespace {

constexpr double kGoldenRatio = 0.6180339887498949;
constexpr size_t kMostPoints = 1024;  // of a span's length: a correlation of 0.95 is then known to 0.003

}  // namespace

Sides::Sides(const Channel& lower, const Channel& upper, double sample_period_s, Integrals& integrals)
    : lower_(lower.values),
      twice_(static_cast<int>(upper.quantity) - static_cast<int>(lower.quantity) == 2),
      T_(sample_period_s),
      integral_(integrals.of(upper, twice_)) {}

void Sides::over(size_t h) { compare(h, samples() - 2 * h, 1.0); }

void Sides::here_and_there(size_t h) {
  const size_t count = samples() - 2 * h, apart = count / kMostPoints;
  const double enough = kGoldenRatio * static_cast<double>(apart);
  const double step = std::max({1.0, kGoldenRatio * static_cast<double>(h) / 4.0, enough});
  compare(h, static_cast<size_t>(static_cast<double>(count - 1) / step) + 1, step);
}

void Sides::compare(size_t h, size_t count, double step) {
  from_lower.resize(count);
  of_upper.resize(count);
  const double steps = static_cast<double>(h), part = twice_ ? 1.0 / (steps * steps) : 0.5 / steps;
  const double per_span = part / (twice_ ? T_ * T_ : T_);
  const double *lower = lower_.data(), *integral = integral_.data();
  double *from = from_lower.data(), *of = of_upper.data();
  const auto each = [&](auto difference) {
    for (size_t k = 0; k < count; ++k) {
      const size_t i = step == 1.0 ? k : static_cast<size_t>(static_cast<double>(k) * step);
      from[k] = difference(lower + i) * per_span;
      of[k] = difference(integral + i) * part;
    }
  };
  if (twice_)
    each([h](const double* at) { return at[2 * h] - 2.0 * at[h] + at[0]; });
  else
    each([h](const double* at) { return at[2 * h] - at[0]; });
}

}  // namespace host_sim::data_check
