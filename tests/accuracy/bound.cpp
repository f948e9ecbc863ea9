#include "tests/accuracy/bound.hpp"

#include <cmath>

#include "hal/rig_file/scaled_double.hpp"

namespace accuracy {
namespace {

using firmware::Batch;
using firmware::BatchTable;
using firmware::Level;

constexpr int kWeight = static_cast<int>(firmware::Weight::kInstrument);

double real(firmware::PackedScaled packed) { return rig_file::to_double(firmware::unpack(packed)); }

// The batches that make up a group: all of a periodic level, else one.
struct Range {
  const Level* level;
  int first, last;
};

std::vector<Range> list_groups(const BatchTable& table) {
  std::vector<Range> ranges;
  for (int l = 0; l < table.level_count; ++l) {
    const Level& level = table.level[l];
    if (level.periodic) {
      ranges.push_back({&level, 0, level.batch_count});
    } else {
      for (int b = 0; b < level.batch_count; ++b) ranges.push_back({&level, b, b + 1});
    }
  }
  return ranges;
}

Eigen::MatrixXd columns(const BatchTable& table, const Range& range) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(table.layout.dof_count, table.layout.unknown_count);
  for (int b = range.first; b < range.last; ++b)
    for (int i = 0; i < table.layout.dof_count; ++i)
      for (int n = table.layout.first[i]; n < table.layout.first[i + 1]; ++n)
        result(i, table.layout.unknown[n]) += real(range.level->batch[b].column[kWeight][n]);
  return result;
}

Eigen::VectorXd observe(const BatchTable& table, const Range& range, const std::vector<double>& truth) {
  const int dofs = table.layout.dof_count;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(3 * dofs);
  for (int b = range.first; b < range.last; ++b)
    for (int i = 0; i < dofs; ++i) {
      const firmware::BatchDof& dof = range.level->batch[b].dof[i];
      result(i) += real(dof.rhs[kWeight]);
      result(dofs + i) += real(dof.kinetic_discrepancy[kWeight]);
      result(2 * dofs + i) += real(dof.elastic_discrepancy[kWeight]);
    }
  result.head(dofs) -=
      columns(table, range) * Eigen::Map<const Eigen::VectorXd>(truth.data(), static_cast<Eigen::Index>(truth.size()));
  return result;
}

Eigen::MatrixXd covariance(const std::vector<Eigen::VectorXd>& draws, Eigen::Index size) {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(size);
  for (const Eigen::VectorXd& draw : draws) mean += draw.head(size) / static_cast<double>(draws.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (const Eigen::VectorXd& draw : draws) sum += (draw.head(size) - mean) * (draw.head(size) - mean).transpose();
  return sum / static_cast<double>(draws.size() - 1);
}

}  // namespace

Bound::Bound(const BatchTable& clean, const std::vector<double>& truth) : truth_(truth) {
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(clean.layout.dof_count, clean.layout.unknown_count);
  groups_.assign(list_groups(clean).size(), Group{none, {}});
}

void Bound::add(const BatchTable& noisy) {
  const std::vector<Range> ranges = list_groups(noisy);
  for (size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].draws.push_back(observe(noisy, ranges[g], truth_));
    groups_[g].sum += columns(noisy, ranges[g]);
  }
}

std::vector<double> Bound::deviations(bool with_identities) const {
  const auto unknowns = static_cast<Eigen::Index>(truth_.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (const Group& group : groups_) {
    const Eigen::Index dofs = group.sum.rows(), size = with_identities ? 3 * dofs : dofs;
    Eigen::MatrixXd wide = Eigen::MatrixXd::Zero(size, unknowns);
    wide.topRows(dofs) = group.sum / static_cast<double>(group.draws.size());
    information += wide.transpose() * covariance(group.draws, size).ldlt().solve(wide);
  }
  const Eigen::MatrixXd inverse = information.inverse();
  std::vector<double> result;
  for (Eigen::Index k = 0; k < unknowns; ++k) result.push_back(std::sqrt(inverse(k, k)));
  return result;
}

}  // namespace accuracy
