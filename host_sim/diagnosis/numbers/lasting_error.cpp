#include "lasting_error.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "../motion/drive_noise.hpp"
#include "elastic_doubt.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kRidge = 1e-9;

std::vector<Prepared> pushed(const std::vector<Prepared>& records, size_t dof) {
  std::vector<Prepared> list = records;
  for (Prepared& p : list)
    if (dof < p.force.size()) p.force[dof].array() += lasting_error_of_force(p, dof);
  return list;
}

// Each channel's rows in units of what the fit left of it.
template <typename Rows>
void weigh(const Vec& mean_square, Index length, Rows& rows) {
  for (Index c = 0; c < mean_square.size(); ++c) rows.middleRows(c * length, length) /= std::sqrt(mean_square[c]);
}

// What the window's own state cannot make of these columns.
Mat without_states(const Mat& states, const Mat& columns) {
  if (states.cols() == 0) return columns;
  const Vec scale = states.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  const Mat unit = states * scale.asDiagonal();
  Mat gram = unit.transpose() * unit;
  gram.diagonal().array() += kRidge;
  return columns - unit * gram.llt().solve(unit.transpose() * columns);
}

// By how much each parameter moves at most: the normal matrix of all windows, and window by window what its error pulls at.
class Moved {
 public:
  Moved(const Task& task, const State& state) : task_(task), state_(state) {}

  Vec by_force(size_t dof) {
    const std::vector<Prepared> others = pushed(task_.records, dof);
    Evaluator as_read(task_.system, state_.model, task_.records), other(task_.system, state_.model, others);
    const Index p = as_read.parameters();
    Mat total = Mat::Zero(p, p);
    std::vector<Vec> pulls;
    WindowRun run, moved;
    for (const Window& w : state_.seen) {
      if (!as_read.run(w, true, false, run) || !other.run(w, false, false, moved)) return Vec::Zero(p);
      Mat rows(run.slopes.rows(), p + 1);
      rows << run.slopes.rightCols(p), moved.residual - run.residual;
      Mat states = run.slopes.leftCols(run.nuisances);
      weigh(state_.fit.mean_square, w.length, rows), weigh(state_.fit.mean_square, w.length, states);
      const Mat own = without_states(states, rows);
      total.noalias() += own.leftCols(p).transpose() * own.leftCols(p);
      pulls.push_back(own.leftCols(p).transpose() * own.col(p));
    }
    const Vec scale = total.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    Mat a = scale.asDiagonal() * total * scale.asDiagonal();
    a.diagonal().array() += kRidge;
    const Eigen::LDLT<Mat> solver(a);
    Vec most = Vec::Zero(p);
    for (const Vec& pull : pulls) most += (scale.asDiagonal() * solver.solve(scale.asDiagonal() * pull)).cwiseAbs();
    return most;
  }

 private:
  const Task& task_;
  const State& state_;
};

}  // namespace

std::vector<Determined> determined_beside_drives(const Task& task, const State& state) {
  std::vector<Determined> found = determined(state.fit, state.model);
  if (found.empty() || massless(task.system.rig)) return found;
  const Vec doubt = elastic_doubt(task, state.model);
  for (size_t i = 0; i < found.size(); ++i) found[i].std = std::hypot(found[i].std, doubt[static_cast<Index>(i)]);
  for (size_t dof = 0; dof < task.records[0].force.size(); ++dof) {
    const auto any = [&](const Prepared& p) { return lasting_error_of_force(p, dof) > 0; };
    if (std::none_of(task.records.begin(), task.records.end(), any)) continue;
    const Vec most = Moved(task, state).by_force(dof);
    for (size_t i = 0; i < found.size(); ++i) found[i].std += most[static_cast<Index>(i)] / kHalfOf95;
  }
  return found;
}

}  // namespace diagnosis::runs
