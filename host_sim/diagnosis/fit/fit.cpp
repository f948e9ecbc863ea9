#include "fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "descent.hpp"
#include "windows_pass.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kLeastWindows = 8;  // from which on the scatter between windows is a measure
constexpr double kForgotten = 10;    // memories of what is left: blocks as long share a tenth of it at most
// Scatter between windows over that between shorter blocks: the 1 % point for a dozen windows. Beyond it what drives
// the rig has noise that a resonance stretches all over a window, small as its share of the whole residual may be.
constexpr double kResembles = 1.5;

}  // namespace

double normal_deviate(double t, double dof) {  // Wallace 1959
  const double z = std::sqrt(dof * std::log1p(t * t / dof)) * (8 * dof + 1) / (8 * dof + 3);
  return t < 0 ? -z : z;
}

size_t approach(const System& system, const std::vector<Prepared>& records, Model& model, std::vector<Window>& windows,
                int iterations, bool only_states) {
  size_t passes = 0;
  descended(system, records, model, windows, iterations, only_states, passes);
  return passes;
}

Fitted fit(const System& system, const std::vector<Prepared>& records, Model& model, std::vector<Window>& windows,
           int iterations, bool only_states) {
  Fitted out;
  size_t passes = 0;
  const Vec weights = descended(system, records, model, windows, iterations, only_states, passes);
  if (weights.size() == 0) return out;
  Evaluator evaluator(system, model, records);
  out.parts = kFiner * parts_for(windows.size());
  WindowsPass now = pass_over(evaluator, windows, &weights, true, out.parts);
  if (!now.ok) return out;
  out.ok = true, out.cost = now.cost, out.mean_square = now.mean_square, out.memory = now.memory;
  for (const Window& w : windows) out.block_length += static_cast<double>(w.length);
  out.block_length /= static_cast<double>(windows.size() * out.parts);
  for (Normal& n : now.windows)
    for (size_t b = 0; b < out.parts; ++b)
      out.block_ss.push_back(n.block_ss[b]), out.gram.push_back(n.block_gram[b]), out.score.push_back(n.block_score[b]);
  return out;
}

size_t parts_for(size_t windows) {
  return windows >= kEnoughWindows ? 1 : (kBlocks + windows - 1) / std::max<size_t>(1, windows);
}

namespace {

constexpr double kAlike = 1e8;  // variance inflation: columns that differ by 10^-4

// Inverse of the normal matrix; rows and columns of what is held are nought.
Mat inverse_of(const Mat& total, const std::vector<bool>& held) {
  const Index p = total.rows();
  Vec scale = total.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  for (Index i = 0; i < p; ++i)
    if (held[static_cast<size_t>(i)]) scale[i] = 0;
  Mat a = scale.asDiagonal() * total * scale.asDiagonal();
  for (Index i = 0; i < p; ++i) a(i, i) = held[static_cast<size_t>(i)] ? 1 : a(i, i) + 1e-12;
  return scale.asDiagonal() * a.ldlt().solve(Mat::Identity(p, p)) * scale.asDiagonal();
}

Mat total_of(const std::vector<Mat>& blocks) {
  Mat total = Mat::Zero(blocks[0].rows(), blocks[0].cols());
  for (const Mat& block : blocks) total += block;
  return total;
}

struct Scatter {
  double se = 0, dof = 1;
};
// together: blocks of one window that are taken as one.
Scatter scatter_of(const Fitted& fit, const Mat& inverse, Index i, size_t together) {
  const Vec direction = inverse.col(i) / inverse(i, i);
  double square = 0, leverage = 0;
  for (size_t b = 0, to = 0; b < fit.gram.size(); b = to) {
    double own = 0, influence = 0;
    to = std::min(b + together, (b / fit.parts + 1) * fit.parts);
    for (size_t k = b; k < to; ++k)
      own += direction.dot(fit.gram[k] * direction), influence += inverse.row(i).dot(fit.score[k]);
    const double h = std::clamp(own * inverse(i, i), 0.0, 0.95);
    influence /= 1 - h;
    square += influence * influence, leverage += h * h;
  }
  return {std::sqrt(square), std::max(1.0, 1 / std::max(1e-12, leverage))};
}

// So that 1.96 of it reach Student's 97.5 % point.
double student_std(const Scatter& s) { return s.se * quantile(boost::math::students_t(s.dof), 0.975) / kHalfOf95; }

// A fit ends where the scores of all blocks together are nought: the scatter of one is nought, that of fewer than kLeastWindows is no
// measure. As many parts of a window at most are a block.
size_t most_together(const Fitted& fit) { return std::clamp(fit.gram.size() / kLeastWindows, size_t{1}, fit.parts); }

// Whether a shape of that term's, or of what acts in its place with its coefficient, is fitted.
bool has_free_shape(const Model& model, size_t term) {
  for (size_t i = 0; i < model.size(); ++i)
    if ((i == term || model[i].host == static_cast<int>(term)) && (model[i].shape_free || model[i].shape2_free))
      return true;
  return false;
}

}  // namespace

double promised_fall(const Fitted& fit) {
  if (fit.gram.empty() || fit.gram[0].rows() == 0) return 0;
  const Mat total = total_of(fit.gram);
  Vec score = Vec::Zero(total.rows());
  for (const Vec& s : fit.score) score += s;
  return 0.5 * score.dot(inverse_of(total, std::vector<bool>(static_cast<size_t>(total.rows()), false)) * score);
}

std::vector<Determined> determined(const Fitted& fit, const Model& model) {
  const std::vector<Parameter> parameters = parameters_of(model);
  const Index p = static_cast<Index>(parameters.size());
  std::vector<Determined> list(parameters.size());
  if (p == 0 || fit.gram.empty()) return list;
  const Mat total = total_of(fit.gram);
  const size_t forgotten = static_cast<size_t>(
      std::clamp(kForgotten * fit.memory / fit.block_length + 1, 1.0, static_cast<double>(fit.parts)));
  const size_t most = most_together(fit);
  std::vector<bool> none(parameters.size(), false), shapes = none;
  for (size_t i = 0; i < parameters.size(); ++i) shapes[i] = parameters[i].shape != 0;
  const Mat inverse = inverse_of(total, none), at_this_shape = inverse_of(total, shapes);
  for (Index i = 0; i < p; ++i) {
    const size_t k = static_cast<size_t>(i);
    Determined& d = list[k];
    d.alike = !parameters[k].shape && total(i, i) * at_this_shape(i, i) > kAlike;
    for (size_t together : {std::min(kFiner, fit.parts), fit.parts}) {  // blocks, then windows
      if (together > kFiner && fit.gram.size() / together < kLeastWindows) continue;
      const Scatter s = scatter_of(fit, inverse, i, together);
      d.std = std::max(d.std, student_std(s));
    }
    if (shapes[k]) continue;
    // without the effect its shape means nothing: whether it is there is asked at this shape
    Scatter s = scatter_of(fit, at_this_shape, i, forgotten);
    if (fit.gram.size() / fit.parts >= kLeastWindows) {
      const Scatter by_windows = scatter_of(fit, at_this_shape, i, fit.parts);
      if (by_windows.se > kResembles * s.se) s = by_windows;
    }
    d.z = normal_deviate(model[parameters[k].term].value / std::max(s.se, 1e-300), s.dof);
    // It is there, and its shape is not determined: what is known of it is its size at this shape.
    if (has_free_shape(model, parameters[k].term) && std::abs(d.z) > kSure &&
        std::abs(model[parameters[k].term].value) < kHalfOf95 * d.std)
      d.std = student_std(forgotten <= most ? s : scatter_of(fit, at_this_shape, i, most));
  }
  return list;
}

}  // namespace diagnosis::runs
