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
      : configuration_(configuration), codes_(codes), step_s_(rig_file::to_double(configuration.sample_period_s)) {
    for (int l = 0; l < configuration.link_count; ++l) clear_.push_back(clear_signs(l));
  }

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
  double rate_of_neighbours(int link, size_t n) const {
    return (4 * (rate(link, n - 1) + rate(link, n + 1)) - rate(link, n - 2) - rate(link, n + 2)) / 6;
  }
  // -1 or 1 where the neighbours' rate is over four times the mean difference between it and the rate, and the rate agrees.
  std::vector<int> clear_signs(int link) const {
    std::vector<int> signs(codes_.size(), 0);
    double sum = 0, count = 0;
    for (size_t n = 2; n + 2 < codes_.size(); ++n) {
      const double own = rate(link, n), neighbours = rate_of_neighbours(link, n);
      sum += std::abs(own - neighbours);
      if (++count == 2048) sum /= 2, count /= 2;
      if (std::abs(neighbours) * count > 4 * sum && own * neighbours > 0) signs[n] = neighbours > 0 ? 1 : -1;
    }
    return signs;
  }
  bool rubs(int i, int link) const {
    for (int t = 0; t < configuration_.term_count; ++t)
      if (configuration_.terms[t].kind == TermKind::kCoulomb && configuration_.terms[t].place == link)
        return configuration_.links[link].node_a == i || configuration_.links[link].node_b == i;
    return false;
  }
  // The weight of DOF i's equation: nothing where a friction at it has no clear sign.
  double weight(int i, size_t n) const {
    for (int l = 0; l < configuration_.link_count; ++l)
      if (rubs(i, l) && clear_[static_cast<size_t>(l)][n] == 0) return 0.0;
    return instrument(i, n);
  }

  // Work of the term's unit force on the DOF, signs aside.
  double work(const firmware::Term& term, int i) const {
    const Signal z = [this, i](size_t n) { return weight(i, n); };
    if (term.kind == TermKind::kMass)
      return integral([&](size_t n) { return z(n) * value(i, Quantity::kAcceleration, n); });
    if (term.kind == TermKind::kStiffness) {
      const firmware::LinkConfiguration& l = configuration_.links[term.place];
      return integral([&](size_t n) {
        return z(n) * (value(l.node_a, Quantity::kDisplacement, n) - value(l.node_b, Quantity::kDisplacement, n));
      });
    }
    if (term.kind == TermKind::kViscous) return integral([&](size_t n) { return z(n) * rate(term.place, n); });
    return integral([&](size_t n) { return z(n) * clear_[term.place][n]; });
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
    const auto q = [&](size_t n) { return weight(i, n); };
    level.counted(b, i) = integral([&](size_t n) { return q(n) * v(n); });
    double rhs = integral([&](size_t n) { return q(n) * value(i, Quantity::kForce, n); });
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
  std::vector<std::vector<int>> clear_;  // per link and sample
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
