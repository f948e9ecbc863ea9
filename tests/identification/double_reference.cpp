#include "tests/identification/double_reference.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hal/rig_file/scaled_double.hpp"

namespace reference {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double real(firmware::PackedScaled packed) { return rig_file::to_double(firmware::unpack(packed)); }

using Data = LevelEnergies;

Data read(const firmware::BatchTable& table, int l) {
  const firmware::Level& level = table.level[l];
  const int dofs = table.layout.dof_count, n = level.batch_count, q = 1;
  Data data(level.periodic, n, dofs, table.layout.unknown_count);
  for (int i = 0; i < dofs; ++i)
    for (int b = 0; b < n; ++b) {
      const firmware::BatchDof& dof = level.batch[b].dof[i];
      data.rhs(b, i) = real(dof.rhs[q]);
      data.kinetic(b, i) = real(dof.kinetic_discrepancy[q]);
      data.elastic(b, i) = real(dof.elastic_discrepancy[q]);
      data.kinetic_end(b, i) = real(dof.kinetic_end);
      data.elastic_end(b, i) = real(dof.elastic_end);
      data.motion(b, i) = real(dof.velocity_square);
      data.clean(b, i) = real(dof.velocity_instrument);
      data.counted(b, i) = real(dof.weight_square);
      for (int s = table.layout.first[i]; s < table.layout.first[i + 1]; ++s)
        data.columns[i](b, table.layout.unknown[s]) = real(level.batch[b].column[q][s]);
    }
  return data;
}

VectorXd centred(const VectorXd& v) { return v.array() - v.mean(); }

// A discrepancy ready for use: its scatter, the value that a row subtracts, and whether it is noise alone.
struct Control {
  VectorXd scatter;
  double total = 0.0, end_variance = 0.0;
  bool valid = false;
};

Control control(const VectorXd& values, const VectorXd& ends, const VectorXd& scale, bool periodic) {
  Control c;
  c.total = values.sum();
  c.scatter = values.cwiseProduct(scale);
  if (periodic) {
    c.scatter = centred(values);
    const VectorXd without = centred(values + ends);
    if (c.total != 0.0 && without.squaredNorm() < c.scatter.squaredNorm()) {
      c.end_variance = (c.scatter.squaredNorm() - without.squaredNorm()) / static_cast<double>(values.size() - 1);
      c.scatter = without;
    }
  }
  const double sum = periodic ? c.total : c.scatter.sum();
  const double squares = c.scatter.squaredNorm() + c.end_variance;
  c.valid = squares > 0.0 && sum * sum < 16.0 * squares;
  return c;
}

struct Whitened {
  MatrixXd columns;
  VectorXd rhs;
  double inflation, freedom;
  bool measured = true;
};

class Reference {
 public:
  Reference(const firmware::CoreConfiguration& configuration, const std::vector<Data>& levels)
      : dofs_(configuration.dof_count), unknowns_(configuration.unknown_count), levels_(levels) {
    joined_ = Eigen::MatrixXi::Identity(dofs_, dofs_);
    for (int l = 0; l < configuration.link_count; ++l) {
      const int a = configuration.links[l].node_a, b = configuration.links[l].node_b;
      if (a < dofs_ && b < dofs_) joined_(a, b) = joined_(b, a) = 1;
    }
  }

  Result solve() {
    start();
    for (int pass = 0; pass < 2; ++pass) reweight();
    return result_;
  }

 private:
  VectorXd scale(const Data& data, int i) const {
    VectorXd s = VectorXd::Ones(data.rhs.rows());
    if (data.periodic) return s;
    const double mean = data.motion.col(i).mean();
    for (Eigen::Index b = 0; b < s.size(); ++b) {
      const double v = data.motion(b, i), z = data.clean(b, i);
      const double counted = data.counted(b, i) == z ? v : v * std::max(data.counted(b, i), 0.0) / z;
      s(b) = v > mean / 17179869184.0 && v - z < z && counted > 0.0 ? 1.0 / std::sqrt(counted) : 0.0;
    }
    return s;
  }

  void start() {
    std::vector<Whitened> rows;
    for (const Data& data : levels_)
      for (int i = 0; i < dofs_; ++i) {
        const double mean = data.motion.col(i).mean();
        const VectorXd s = scale(data, i);
        if (data.periodic) {
          const double weight = 1.0 / std::sqrt(data.motion.col(i).sum() * mean);
          rows.push_back(
              {data.columns[i].colwise().sum() * weight, VectorXd::Constant(1, data.rhs.col(i).sum() * weight), 1, 1});
        } else {
          rows.push_back({s.asDiagonal() * data.columns[i] / std::sqrt(mean),
                          s.cwiseProduct(data.rhs.col(i)) / std::sqrt(mean), 1, 1, false});
        }
      }
    fit(rows);
  }

  void reweight() {
    std::vector<Whitened> rows;
    for (const Data& data : levels_) whiten(data, rows);
    fit(rows);
  }

  // A sum of squares below this is no scatter: 2^-35 of the rows' energies.
  double rounding(const Data& data, const VectorXd& scales, int i) const {
    const MatrixXd works = scales.asDiagonal() * data.columns[i] * result_.value.asDiagonal();
    return std::ldexp(works.squaredNorm() + scales.cwiseProduct(data.rhs.col(i)).squaredNorm(), -70);
  }

  void whiten(const Data& data, std::vector<Whitened>& rows) const {
    std::vector<Control> controls;
    std::vector<VectorXd> scales, residuals;
    for (int i = 0; i < dofs_; ++i) {
      scales.push_back(scale(data, i));
      controls.push_back(control(data.kinetic.col(i), data.kinetic_end.col(i), scales[i], data.periodic));
      controls.push_back(control(data.elastic.col(i), data.elastic_end.col(i), scales[i], data.periodic));
      const VectorXd r = (data.rhs.col(i) - data.columns[i] * result_.value).cwiseProduct(scales[i]);
      residuals.push_back(data.periodic ? centred(r) : r);
    }
    for (int i = 0; i < dofs_; ++i) whiten_row(data, i, controls, scales, residuals, rows);
  }

  void whiten_row(const Data& data, int i, const std::vector<Control>& controls, const std::vector<VectorXd>& scales,
                  const std::vector<VectorXd>& residuals, std::vector<Whitened>& rows) const {
    const auto used = static_cast<double>((scales[i].array() != 0.0).count());
    const auto limit = static_cast<size_t>(std::min((used - 1.0) / 7.0, 12.0));
    std::vector<int> chosen;  // controls 2 i + which; rows 1000 + j
    const auto add_controls = [&](int j) {
      for (int c : {2 * j, 2 * j + 1})
        if (controls[c].valid) chosen.push_back(c);
    };
    add_controls(i);
    for (int j = 0; j < i; ++j)
      if (joined_(i, j) && residuals[j].squaredNorm() > rounding(data, scales[j], j)) chosen.push_back(1000 + j);
    for (int j = 0; j < dofs_; ++j)
      if (j != i && joined_(i, j)) add_controls(j);
    if (chosen.size() > limit) chosen.resize(limit);
    // Regression with the controls' end variance as one extra observation each.
    const auto k = static_cast<Eigen::Index>(chosen.size()), n = data.rhs.rows();
    MatrixXd x = MatrixXd::Zero(n + k, k);
    VectorXd y = VectorXd::Zero(n + k);
    y.head(n) = residuals[i];
    for (Eigen::Index c = 0; c < k; ++c) {
      const int index = chosen[static_cast<size_t>(c)];
      x.col(c).head(n) = index >= 1000 ? residuals[index - 1000] : controls[index].scatter;
      if (index < 1000) x(n + c, c) = std::sqrt(controls[index].end_variance);
    }
    const VectorXd b = k > 0 ? VectorXd(x.colPivHouseholderQr().solve(y)) : VectorXd(0);
    const double left = std::max((y - x * b).squaredNorm(), rounding(data, scales[i], i));
    const double freedom = used - static_cast<double>(k) - (data.periodic ? 1.0 : 0.0);
    const double deviation = std::sqrt((data.periodic ? used : 1.0) * left / freedom);
    Whitened row{scales[i].asDiagonal() * data.columns[i], scales[i].cwiseProduct(data.rhs.col(i)), 0, freedom};
    if (data.periodic)
      row = {data.columns[i].colwise().sum(), VectorXd::Constant(1, data.rhs.col(i).sum()), 0, freedom};
    for (Eigen::Index c = 0; c < k; ++c) {
      const int index = chosen[static_cast<size_t>(c)], j = index - 1000;
      if (index >= 1000) {
        row.columns -= b(c) * (data.periodic ? MatrixXd(data.columns[j].colwise().sum())
                                             : MatrixXd(scales[j].asDiagonal() * data.columns[j]));
        row.rhs -= b(c) * (data.periodic ? VectorXd::Constant(1, data.rhs.col(j).sum())
                                         : VectorXd(scales[j].cwiseProduct(data.rhs.col(j))));
      } else {
        row.rhs -= b(c) * (data.periodic ? VectorXd::Constant(1, controls[index].total) : controls[index].scatter);
      }
    }
    for (Eigen::Index r = 0; r < row.rhs.size(); ++r)
      if (!data.periodic && scales[i](r) == 0.0) row.rhs(r) = 0.0, row.columns.row(r).setZero();
    row.columns /= deviation;
    row.rhs /= deviation;
    row.inflation = (used - 2.0) / (used - static_cast<double>(k) - 2.0);
    rows.push_back(row);
  }

  void fit(const std::vector<Whitened>& rows) {
    Eigen::Index count = 0;
    for (const Whitened& row : rows) count += row.rhs.size();
    MatrixXd a(count, unknowns_);
    VectorXd y(count);
    count = 0;
    for (const Whitened& row : rows) {
      a.middleRows(count, row.rhs.size()) = row.columns;
      y.segment(count, row.rhs.size()) = row.rhs;
      count += row.rhs.size();
    }
    result_.value = a.colPivHouseholderQr().solve(y);
    const MatrixXd gain = a.completeOrthogonalDecomposition().pseudoInverse();
    double used = 0.0;
    for (Eigen::Index r = 0; r < count; ++r) used += a.row(r).squaredNorm() > 0.0 ? 1.0 : 0.0;
    const double freedom = used - unknowns_;
    const double misfit = freedom > 0.0 ? (y - a * result_.value).squaredNorm() / freedom : 0.0;
    const double factor = misfit > 1.0 + std::sqrt(50.0 / freedom) + 6.0 / freedom ? misfit : 1.0;
    const Eigen::ArrayXd repeated = result_.value.array() / 1048576.0;  // errors that no scatter shows: 2^-20
    const VectorXd variance = with_levels(rows, gain, y - a * result_.value, shares(rows, a, gain));
    result_.deviation = (variance.array() * factor + repeated.square()).sqrt();
  }

  // Per parameter (rows) the variance that each equation of a level (columns) has a share of, per degree of freedom that the fit
  // leaves its residuals; and those degrees of freedom.
  struct Shares {
    MatrixXd of;
    VectorXd freedom;
  };

  Shares shares(const std::vector<Whitened>& rows, const MatrixXd& a, const MatrixXd& gain) const {
    Shares s{MatrixXd(unknowns_, static_cast<Eigen::Index>(rows.size())), VectorXd(rows.size())};
    Eigen::Index at = 0;
    for (size_t i = 0; i < rows.size(); ++i) {
      const Eigen::Index n = rows[i].rhs.size(), g = static_cast<Eigen::Index>(i);
      const bool alone =
          levels_.front().periodic || !rows[i].measured;  // scatter about the level's mean, not about the fit
      const double hat = alone ? 0.0 : (a.middleRows(at, n) * gain.middleCols(at, n)).trace();
      s.freedom(g) = std::max(1.0, rows[i].freedom - hat);
      s.of.col(g) = gain.middleCols(at, n).rowwise().squaredNorm() * rows[i].inflation * rows[i].freedom / s.freedom(g);
      at += n;
    }
    return s;
  }

  // Three levels or more that pull a parameter apart by more than chi-square allows once in a thousand give it their scatter.
  VectorXd with_levels(const std::vector<Whitened>& rows, const MatrixXd& gain, const VectorXd& residual,
                       const Shares& shares) const {
    const VectorXd variance = shares.of.rowwise().sum();
    VectorXd widened = variance;
    const bool measured = std::all_of(rows.begin(), rows.end(), [](const Whitened& row) { return row.measured; });
    for (Eigen::Index k = 0; k < variance.size() && measured; ++k) {  // Meier 1953: the weights are estimates too
      const Eigen::ArrayXd part = shares.of.row(k).transpose().array() / variance(k);
      widened(k) *= 1.0 + 4.0 * (part * (1.0 - part) / shares.freedom.array()).sum();
    }
    const size_t levels = levels_.size();
    if (levels < 3 || levels_.front().periodic) return widened;
    VectorXd squares = VectorXd::Zero(unknowns_);
    Eigen::Index at = 0;
    for (size_t l = 0; l < levels; ++l) {
      Eigen::Index count = 0;
      for (size_t r = l * rows.size() / levels; r < (l + 1) * rows.size() / levels; ++r) count += rows[r].rhs.size();
      squares += (gain.middleCols(at, count) * residual.segment(at, count)).array().square().matrix();
      at += count;
    }
    const double freedom = static_cast<double>(levels) - 1.0;
    const double limit = 1.0 + 4.4 / std::sqrt(freedom) + 6.2 / freedom;
    for (Eigen::Index k = 0; k < variance.size(); ++k) {
      const double between = squares(k) * static_cast<double>(levels) / freedom;
      if (between > variance(k) * limit) widened(k) = between;
    }
    return widened;
  }

  int dofs_, unknowns_;
  Eigen::MatrixXi joined_;
  std::vector<Data> levels_;
  Result result_;
};

}  // namespace

LevelEnergies::LevelEnergies(bool is_periodic, Eigen::Index batches, int dofs, int unknowns) : periodic(is_periodic) {
  for (MatrixXd* m : {&rhs, &kinetic, &elastic, &kinetic_end, &elastic_end, &motion, &clean, &counted})
    m->setZero(batches, dofs);
  columns.assign(static_cast<size_t>(dofs), MatrixXd::Zero(batches, unknowns));
}

Result estimate(const firmware::CoreConfiguration& configuration, const std::vector<LevelEnergies>& levels) {
  return Reference(configuration, levels).solve();
}

Result estimate(const firmware::CoreConfiguration& configuration, const firmware::BatchTable& table) {
  std::vector<LevelEnergies> levels;
  for (int l = 0; l < table.level_count; ++l) levels.push_back(read(table, l));
  return estimate(configuration, levels);
}

}  // namespace reference
