#include "tests/identification/double_energies.hpp"

#include <cmath>
#include <functional>

#include "hal/rig_file/scaled_double.hpp"

namespace reference {
namespace {

using firmware::Quantity;
using firmware::TermKind;
using Signal = std::function<double(size_t)>;

class Energies {
 public:
  Energies(const firmware::CoreConfiguration& configuration, const std::vector<firmware::RawSample>& codes)
      : configuration_(configuration), codes_(codes), step_s_(rig_file::to_double(configuration.sample_period_s)) {}

  double value(int node, Quantity quantity, size_t n) const {
    if (node == firmware::kGroundNode) return 0.0;
    const int q = static_cast<int>(quantity);
    return codes_[n].code[node][q] * rig_file::to_double(configuration_.channels[node][q].unit_per_code);
  }

  void batch(LevelEnergies& level, Eigen::Index b, size_t from, size_t to) {
    from_ = from, to_ = to;
    for (int i = 0; i < configuration_.dof_count; ++i) dof(level, b, i);
  }

 private:
  // h (p_0 / 2 + p_1 + ... + p_N / 2) - h (p'_N - p'_0) / 12 with central differences for the slopes p'.
  double integral(const Signal& p) const {
    double sum = 0.5 * (p(from_) + p(to_));
    for (size_t n = from_ + 1; n < to_; ++n) sum += p(n);
    return step_s_ * (sum - (p(to_ + 1) - p(to_ - 1) - p(from_ + 1) + p(from_ - 1)) / 24.0);
  }

  // The velocity at n as the cubic through its four neighbours has it.
  double instrument(int i, size_t n) const {
    const auto v = [&](size_t at) { return value(i, Quantity::kVelocity, at); };
    return (4.0 * (v(n - 1) + v(n + 1)) - v(n - 2) - v(n + 2)) / 6.0;
  }

  double rate(int link, size_t n) const {
    const firmware::LinkConfiguration& l = configuration_.links[link];
    return value(l.node_a, Quantity::kVelocity, n) - value(l.node_b, Quantity::kVelocity, n);
  }
  double smooth_rate(int link, size_t n) const {
    return 10 * rate(link, n) + 4 * (rate(link, n - 2) + rate(link, n + 2)) + rate(link, n - 1) + rate(link, n + 1);
  }

  // Work of the term's unit force on the DOF, signs aside: friction extrapolated to a rate without noise.
  double work(const firmware::Term& term, int i) const {
    const Signal z = [this, i](size_t n) { return instrument(i, n); };
    if (term.kind == TermKind::kMass)
      return integral([&](size_t n) { return z(n) * value(i, Quantity::kAcceleration, n); });
    if (term.kind == TermKind::kStiffness) {
      const firmware::LinkConfiguration& l = configuration_.links[term.place];
      return integral([&](size_t n) {
        return z(n) * (value(l.node_a, Quantity::kDisplacement, n) - value(l.node_b, Quantity::kDisplacement, n));
      });
    }
    if (term.kind == TermKind::kViscous) return integral([&](size_t n) { return z(n) * rate(term.place, n); });
    const auto sign = [](double w) { return w > 0.0 ? 1.0 : w < 0.0 ? -1.0 : 0.0; };
    const double own = integral([&](size_t n) { return z(n) * sign(rate(term.place, n)); });
    const double smooth = integral([&](size_t n) { return z(n) * sign(smooth_rate(term.place, n)); });
    constexpr double kNoiseLeft = 67.0 / 200.0;  // (10^2 + 2 * 4^2 + 2 * 1^2) / 20^2 = 134/400
    return (smooth - kNoiseLeft * own) / (1.0 - kNoiseLeft);
  }

  void dof(LevelEnergies& level, Eigen::Index b, int i) {
    const auto x = [&](size_t n) { return value(i, Quantity::kDisplacement, n); };
    const auto v = [&](size_t n) { return value(i, Quantity::kVelocity, n); };
    const auto a = [&](size_t n) { return value(i, Quantity::kAcceleration, n); };
    const auto z = [&](size_t n) { return instrument(i, n); };
    level.kinetic_end(b, i) = 0.5 * (v(to_) * v(to_) - v(from_) * v(from_));
    level.elastic_end(b, i) = 0.5 * (x(to_) * x(to_) - x(from_) * x(from_));
    level.kinetic(b, i) = integral([&](size_t n) { return z(n) * a(n); }) - level.kinetic_end(b, i);
    level.elastic(b, i) = integral([&](size_t n) { return z(n) * x(n); }) - level.elastic_end(b, i);
    level.motion(b, i) = integral([&](size_t n) { return v(n) * v(n); });
    level.clean(b, i) = integral([&](size_t n) { return z(n) * v(n); });
    double rhs = integral([&](size_t n) { return z(n) * value(i, Quantity::kForce, n); });
    for (int t = 0; t < configuration_.term_count; ++t) {
      const firmware::Term& term = configuration_.terms[t];
      double sign = 1.0;
      if (term.kind == TermKind::kMass) {
        if (term.place != i) continue;
      } else {
        const firmware::LinkConfiguration& l = configuration_.links[term.place];
        if (l.node_a != i && l.node_b != i) continue;
        sign = l.node_a == i ? 1.0 : -1.0;
      }
      const double energy = sign * work(term, i);
      if (term.unknown >= 0) {
        level.columns[static_cast<size_t>(i)](b, term.unknown) += energy;
      } else {
        rhs -= energy * rig_file::to_double(term.value);
      }
    }
    level.rhs(b, i) = rhs;
  }

  const firmware::CoreConfiguration& configuration_;
  const std::vector<firmware::RawSample>& codes_;
  double step_s_;
  size_t from_ = 0, to_ = 0;
};

}  // namespace

LevelEnergies energies(const firmware::CoreConfiguration& configuration, const std::vector<firmware::RawSample>& codes,
                       bool periodic, const std::vector<uint32_t>& batch_samples, size_t first) {
  LevelEnergies level(periodic, static_cast<Eigen::Index>(batch_samples.size()), configuration.dof_count,
                      configuration.unknown_count);
  Energies sums(configuration, codes);
  for (size_t b = 0, from = first; b < batch_samples.size(); from += batch_samples[b++])
    sums.batch(level, static_cast<Eigen::Index>(b), from, from + batch_samples[b]);
  return level;
}

}  // namespace reference
