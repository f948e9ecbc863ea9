#include "windows_pass.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "outer_sums.hpp"
#include "run_windows.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kRidge = 1e-9;  // of a column's square: what is not determined stays where it is

// Correlation of what is left, channel by channel, at lags that double every third step: sums over windows.
class Resemblance {
 public:
  explicit Resemblance(Index channels) : zero_(Vec::Zero(channels)) {
    for (double lag = 1; lag < 4000; lag *= 1.26)
      if (lags_.empty() || static_cast<Index>(lag) > lags_.back()) lags_.push_back(static_cast<Index>(lag));
    products_ = Mat::Zero(channels, static_cast<Index>(lags_.size())), squares_ = products_;
  }
  void add(const Vec& residual, Index length) {
    for (Index c = 0; c < zero_.size(); ++c) {
      const auto r = residual.segment(c * length, length);
      for (size_t i = 0; i < lags_.size() && 2 * lags_[i] < length; ++i) {
        const Index n = length - lags_[i], k = static_cast<Index>(i);
        products_(c, k) += r.head(n).dot(r.tail(n)),
            squares_(c, k) += 0.5 * (r.head(n).squaredNorm() + r.tail(n).squaredNorm());
      }
    }
  }
  // Sum over all lags of the squared correlation, the worst channel's.
  double memory() const {
    double worst = 1;
    for (Index c = 0; c < zero_.size(); ++c) {
      double sum = 1;
      for (size_t i = 0; i < lags_.size(); ++i) {
        const Index k = static_cast<Index>(i);
        if (!(squares_(c, k) > 0)) break;
        const double width = static_cast<double>(lags_[i] - (i ? lags_[i - 1] : 0));
        sum += 2 * width * std::pow(products_(c, k) / squares_(c, k), 2);
      }
      worst = std::max(worst, sum);
    }
    return worst;
  }

 private:
  Vec zero_;
  std::vector<Index> lags_;
  Mat products_, squares_;
};

// What each part of a window says, with the window's state beside; run is weighted.
void take_blocks(const WindowRun& run, const Window& w, size_t parts, const Vec& weights, Normal& n) {
  const Index s = run.nuisances, p = run.slopes.cols() - s, channels = weights.size();
  Mat columns = run.slopes.rightCols(p);
  Vec residual = run.residual;
  if (s > 0 && n.state_step.size() > 0) {
    columns.noalias() -= run.slopes.leftCols(s) * n.states_inverse_cross;
    residual.noalias() -= run.slopes.leftCols(s) * n.state_step;
  }
  for (size_t part = 0; part < parts; ++part) {
    const Index from = static_cast<Index>(part) * w.length / static_cast<Index>(parts),
                count = static_cast<Index>(part + 1) * w.length / static_cast<Index>(parts) - from;
    Mat gram = Mat::Zero(p, p);
    Vec score = Vec::Zero(p), ss(channels);
    for (Index c = 0; c < channels; ++c) {
      const auto b = columns.middleRows(c * w.length + from, count);
      const auto r = residual.segment(c * w.length + from, count);
      gram.noalias() += b.transpose() * b, score.noalias() += b.transpose() * r;
      ss[c] = run.residual.segment(c * w.length + from, count).squaredNorm() / (weights[c] * weights[c]);
    }
    n.block_gram.push_back(gram), n.block_score.push_back(score), n.block_ss.push_back(ss);
  }
}

// What a weighted run with slopes says.
void take_slopes(const WindowRun& run, Normal& n) {
  const Index s = run.nuisances, p = run.slopes.cols() - s;
  Mat gram = Mat::Zero(s + p, s + p);
  const Rows rows{run.slopes.data(), s + p, s + p};
  add_outer_sums(rows, rows, run.slopes.rows(), gram.data(), true);
  gram.triangularView<Eigen::StrictlyUpper>() = gram.transpose();
  const Vec right = run.slopes.transpose() * run.residual;
  if (s > 0) {
    Mat a = gram.topLeftCorner(s, s);
    const Vec scale = a.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    a = scale.asDiagonal() * a * scale.asDiagonal();
    n.state_gram = a, n.cross = gram.topRightCorner(s, p), n.state_scale = scale, n.state_right = right.head(s);
    a.diagonal().array() += kRidge;
    const Eigen::LLT<Mat> solver(a);
    n.states_inverse_cross = scale.asDiagonal() * solver.solve(scale.asDiagonal() * gram.topRightCorner(s, p));
    n.state_step = scale.asDiagonal() * solver.solve(scale.asDiagonal() * right.head(s));
    n.gram = gram.bottomRightCorner(p, p) - gram.bottomLeftCorner(p, s) * n.states_inverse_cross;
    n.score = right.tail(p) - n.states_inverse_cross.transpose() * right.head(s);
  } else {
    n.gram = gram, n.score = right;
  }
}

// weights: nullptr where no slopes are asked for. The run is weighted afterwards.
Normal normal_of(WindowRun& run, const Window& w, const Vec* weights, Index channels, size_t parts) {
  Normal n;
  n.ss.resize(channels);
  for (Index c = 0; c < channels; ++c) n.ss[c] = run.residual.segment(c * w.length, w.length).squaredNorm();
  if (parts > 0) n.residual = run.residual;
  if (!weights) return n;
  for (Index c = 0; c < channels; ++c) {
    run.slopes.middleRows(c * w.length, w.length) *= (*weights)[c];
    run.residual.segment(c * w.length, w.length) *= (*weights)[c];
  }
  take_slopes(run, n);
  if (parts > 0) take_blocks(run, w, parts, *weights, n);
  return n;
}

}  // namespace

WindowsPass pass_over(Evaluator& evaluator, const std::vector<Window>& windows, const Vec* weights, bool slopes,
                      size_t parts) {
  WindowsPass pass;
  const Index channels = static_cast<Index>(evaluator.traces(0).size());
  pass.windows.resize(windows.size());
  const bool finite = run_windows(evaluator, windows, slopes, [&](size_t i, WindowRun& run, size_t) {
    pass.windows[i] = normal_of(run, windows[i], slopes ? weights : nullptr, channels, parts);
  });
  if (!finite) return {};
  Vec sum = Vec::Zero(channels);
  double samples = 0;
  Resemblance resemblance(channels);
  for (size_t i = 0; i < windows.size(); ++i) {
    Normal& n = pass.windows[i];
    sum += n.ss, samples += static_cast<double>(windows[i].length);
    if (parts > 0) resemblance.add(n.residual, windows[i].length);
    n.residual.resize(0);
  }
  pass.mean_square = (sum / std::max(1.0, samples)).cwiseMax(1e-300);
  pass.cost = 0.5 * samples * pass.mean_square.array().log().sum();
  pass.ok = std::isfinite(pass.cost);
  if (parts > 0) pass.memory = resemblance.memory();
  return pass;
}

}  // namespace diagnosis::runs
