// From the channels of a DOF to its spectra under the outer ramp g: those of g x, (g x)', (g x)''.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "motion.hpp"
#include "series.hpp"

namespace diagnosis {
namespace {

using host_sim::Quantity;
constexpr Quantity kOrder[] = {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration};
constexpr double kSlowShare = 0.05;  // of a displacement's rms: what it has below the rows, about

using Motion = std::array<Series, 3>;  // displacement, velocity, acceleration over time
using Spectra3 = std::array<Spectrum, 3>;

// An integral about its mean in each ramp, the only places where it is needed.
Series integral_in_ramps(const Series& y, const FusedRecord& f) {
  Series sum = integral(y, f.period_s);
  const Eigen::Index half = sum.size() / 2,
                     ramp = std::max<Eigen::Index>(1, (f.outer.weight.head(half).array() < 1).count());
  sum.head(half).array() -= sum.head(ramp).mean();
  sum.tail(half).array() -= sum.tail(ramp).mean();
  return sum;
}

// Central differences, exact for quartics but at the ends, where the ramp is nought.
Series derivative_of(const Series& y, double period_s) {
  const Eigen::Index n = y.size();
  Series out = Series::Zero(n);
  for (Eigen::Index i = 2; i + 2 < n; ++i)
    out[i] = (8 * (y[i + 1] - y[i - 1]) - (y[i + 2] - y[i - 2])) / (12 * period_s);
  return out;
}

Spectra3 spectra_of(const Motion& y, const FusedRecord& f, const std::array<bool, 3>& measured) {
  const Ramp& g = f.outer;
  Spectra3 z;
  if (measured[0]) z[0] = f.fourier->forward(g.weight.cwiseProduct(y[0]));
  if (measured[1]) z[1] = f.fourier->forward(g.weight.cwiseProduct(y[1]) + g.slope.cwiseProduct(y[0]));
  if (measured[2])
    z[2] = f.fourier->forward(g.weight.cwiseProduct(y[2]) + 2 * g.slope.cwiseProduct(y[1]) + g.bend.cwiseProduct(y[0]));
  return z;
}

// A motion that may be added to an integrated one, and its likely size.
struct Constant {
  Motion motion;
  double size;
};

// The zero of the integrated channel, and in each ramp the constants of integration.
std::vector<Constant> constants_of(const FusedRecord& f, size_t integrated, const std::array<double, 3>& rms) {
  const Eigen::Index n = static_cast<Eigen::Index>(f.samples), half = n / 2;
  const Series zero = Series::Zero(n), one = Series::Ones(n);
  std::vector<Constant> list;
  const auto add = [&](size_t quantity, const Series& mask) {
    Motion m{zero, zero, zero};
    m[quantity] = mask;
    for (size_t q = quantity; q-- > 0;) m[q] = mask.cwiseProduct(integral_in_ramps(m[q + 1], f));
    list.push_back({m, rms[quantity]});
  };
  add(integrated, one);
  for (bool end : {false, true}) {
    Series mask = zero;
    (end ? mask.tail(half) : mask.head(half)).setOnes();
    for (size_t q = 0; q < integrated; ++q) add(q, mask);
  }
  return list;
}

// Adds the constants with which least is left below the rows, against noise and what slow motion there may be.
void settle_constants(const FusedRecord& f, const std::array<bool, 3>& measured, size_t integrated, Spectra3& z) {
  const double energy = f.outer.weight.squaredNorm(), bins = static_cast<double>(f.samples);
  const Eigen::Index rows = std::max<Eigen::Index>(f.first_beyond(f.slow_Hz), 3);
  std::array<double, 3> rms{};
  Spectrum slower = z[integrated];
  for (size_t q = integrated + 1; q-- > 0;) {
    rms[q] = std::sqrt(mean_square(slower, energy, rows));
    for (Eigen::Index i = 1; i < slower.size(); ++i) slower[i] /= derivative(f.omega(i), 1);
  }
  const std::vector<Constant> constants = constants_of(f, integrated, rms);
  std::vector<Spectra3> columns;
  for (const Constant& c : constants) columns.push_back(spectra_of(c.motion, f, measured));
  const Eigen::Index count = static_cast<Eigen::Index>(columns.size());
  const double noise = z[integrated]
                           .segment(static_cast<Eigen::Index>(0.3 * bins), static_cast<Eigen::Index>(0.18 * bins))
                           .squaredNorm() /
                       (0.18 * bins);
  const double slow = std::pow(kSlowShare * rms[0], 2) * energy * bins / (2 * static_cast<double>(rows));
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2 * rows + count, count);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(2 * rows + count);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double weight =
        1 / std::sqrt(noise + slow * std::norm(derivative(f.omega(i), static_cast<int>(integrated))) + 1e-280);
    const auto put = [&](auto&& row, Complex value) {
      row(2 * i) = weight * value.real(), row(2 * i + 1) = weight * value.imag();
    };
    for (Eigen::Index k = 0; k < count; ++k) {
      const double size = constants[static_cast<size_t>(k)].size;
      put(a.col(k), size * columns[static_cast<size_t>(k)][integrated][i]);
    }
    put(b, -z[integrated][i]);
  }
  a.bottomRows(count).setIdentity();
  const Eigen::VectorXd value = a.colPivHouseholderQr().solve(b);
  for (Eigen::Index k = 0; k < count; ++k)
    for (size_t q = integrated; q < 3; ++q)
      if (measured[q]) z[q] += value[k] * constants[static_cast<size_t>(k)].size * columns[static_cast<size_t>(k)][q];
}

}  // namespace

DofSpectra transform(const host_sim::Record& record, int dof, const FusedRecord& f) {
  DofSpectra s;
  Motion y;
  for (size_t q = 0; q < 3; ++q) {
    const host_sim::Channel* c = record.find(kOrder[q], dof);
    if (!c) continue;
    s.measured[q] = true;
    s.channel[q] = c->name;
    y[q] = Series::Map(c->values.data(), static_cast<Eigen::Index>(f.samples));
  }
  if (!s.any()) return s;
  if (!s.measured[1]) y[1] = s.measured[0] ? derivative_of(y[0], f.period_s) : integral_in_ramps(y[2], f);
  if (!s.measured[0]) y[0] = integral_in_ramps(y[1], f);
  s.z = spectra_of(y, f, s.measured);
  if (!s.measured[0]) settle_constants(f, s.measured, s.measured[1] ? 1 : 2, s.z);
  return s;
}

}  // namespace diagnosis
