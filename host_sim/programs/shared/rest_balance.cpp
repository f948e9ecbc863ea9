#include "host_sim/programs/shared/rest_balance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "host_sim/force_balance/force_balance.hpp"

namespace host_sim {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kAtRest = 1e-5;    // of a spring's elongation, rms: friction may be a thousandth of its force
constexpr double kFarthest = 1.0;   // of it: farther off is not the mean of a force, but a model that is another rig's
constexpr double kDistinct = 1e-6;  // of the stiffest direction: below it nothing holds the rig there, and it stays

// Of what is left of each equation of motion, over these records.
Eigen::VectorXd mean_left(MeanOf of, const rig_file::RigModel& rig, const Record* begin, const Record* end) {
  const auto dofs = static_cast<Eigen::Index>(rig.dofs.size());
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(dofs), weights = sum;
  for (const Record* record = begin; record != end; ++record) {
    const ForceBalance balance = force_balance(rig, *record);
    const size_t count = balance.residual.front().size();
    for (size_t k = 0; k < count; ++k) {
      const double s = std::sin(kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(count)), bell = s * s;
      for (size_t i = 0; i < rig.dofs.size(); ++i) {
        const double speed = balance.velocity[i][k], weight = of == MeanOf::kDriven ? bell : bell * speed * speed;
        sum[static_cast<Eigen::Index>(i)] += weight * balance.residual[i][k];
        weights[static_cast<Eigen::Index>(i)] += weight;
      }
    }
  }
  return sum.cwiseQuotient(weights);
}

// Forces on the DOFs per displacement of the channels' DOFs.
Eigen::MatrixXd stiffness_of(const rig_file::RigModel& rig, const std::vector<int>& moved) {
  Eigen::MatrixXd stiffness =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rig.dofs.size()), static_cast<Eigen::Index>(moved.size()));
  for (const rig_file::Link& link : rig.links)
    for (size_t c = 0; c < moved.size(); ++c) {
      const double per = link.stiffness_N_m.value * ((link.a == moved[c] ? 1 : 0) - (link.b == moved[c] ? 1 : 0));
      if (link.a >= 1) stiffness(link.a - 1, static_cast<Eigen::Index>(c)) += per;
      if (link.b >= 1) stiffness(link.b - 1, static_cast<Eigen::Index>(c)) -= per;
    }
  return stiffness;
}

double rms_of(const std::vector<Record>& records, size_t channel) {
  double squares = 0.0, count = 0.0;
  for (const Record& record : records)
    for (const double value : record.channels[channel].values) squares += value * value, count += 1.0;
  return std::sqrt(squares / std::max(1.0, count));
}

// Whether a spring between these channels' DOFs, or from one of them to where nothing is counted anew, is bent by it. Masses that float
// may be far away together.
bool bends_a_spring(const rig_file::RigModel& rig, const std::vector<int>& moved, const std::vector<size_t>& channels,
                    const Eigen::VectorXd& off, const std::vector<Record>& records) {
  const auto index_of = [&](int dof) { return std::find(moved.begin(), moved.end(), dof) - moved.begin(); };
  const auto none = static_cast<std::ptrdiff_t>(moved.size());
  for (const rig_file::Link& link : rig.links) {
    const std::ptrdiff_t a = index_of(link.a), b = index_of(link.b);
    if (link.stiffness_N_m.value == 0.0 || (a == none && b == none)) continue;
    const double by = (a == none ? 0.0 : off[a]) - (b == none ? 0.0 : off[b]);
    double squares = 0.0, count = 0.0;
    for (const Record& record : records)
      for (size_t i = 0; i < record.samples(); ++i, count += 1.0) {
        const auto at = [&](std::ptrdiff_t c) {
          return c == none ? 0.0 : record.channels[channels[static_cast<size_t>(c)]].values[i];
        };
        squares += (at(a) - at(b)) * (at(a) - at(b));
      }
    if (by * by * count > kAtRest * kAtRest * squares) return true;
  }
  return false;
}

}  // namespace

bool balance_rest(MeanOf of, const rig_file::RigModel& rig, const std::vector<size_t>& channels,
                  SharedRecords& records) {
  if (channels.empty() || records.get().empty()) return false;
  std::vector<int> moved;
  for (const size_t c : channels) moved.push_back(records.get().front().channels[c].dof);
  const Eigen::MatrixXd stiffness = stiffness_of(rig, moved);
  // Of the smallest shift: masses that no spring ties to the ground are at rest anywhere together.
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(kDistinct);
  solver.compute(stiffness);
  const Record* const first = records.get().data();
  const size_t each = of == MeanOf::kDriven ? records.get().size() : 1;
  std::vector<Eigen::VectorXd> off;
  bool any = false;
  for (size_t r = 0; r < records.get().size(); r += each) {
    off.push_back(solver.solve(mean_left(of, rig, first + r, first + r + each)));
    for (size_t c = 0; c < channels.size(); ++c) {
      const double share = std::abs(off.back()[static_cast<Eigen::Index>(c)]) / rms_of(records.get(), channels[c]);
      if (!(share < kFarthest)) return false;
    }
    any = any || bends_a_spring(rig, moved, channels, off.back(), records.get());
  }
  if (!any) return false;
  std::vector<Record>& own = records.own();
  for (size_t r = 0; r < own.size(); ++r)
    for (size_t c = 0; c < channels.size(); ++c)
      for (double& value : own[r].channels[channels[c]].values) value += off[r / each][static_cast<Eigen::Index>(c)];
  return true;
}

}  // namespace host_sim
