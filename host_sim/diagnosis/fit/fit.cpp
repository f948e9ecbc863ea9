#include "fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <optional>

#include "outer_sums.hpp"
#include "run_windows.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kRidge = 1e-9;          // of a column's square: what is not determined stays where it is
constexpr int kTries = 5;                // of a step, each damped more
constexpr double kAstrayDamping = 1e-3;  // of the state of a window that its step led astray, in units of its columns
constexpr double kAstray = 100;          // times a window's error before its step: it has left the motion altogether
constexpr double kSettled = 0.02;        // of the cost: a fall that no test can notice
constexpr double kLongestStep = 0.5;     // of a shape's logarithm
constexpr size_t kLeastWindows = 8;      // from which on the scatter between windows is a measure
constexpr double kLeastShare = 0.3;      // of a positive number, that one step may leave of it
constexpr double kForgotten = 10;        // memories of what is left: blocks as long share a tenth of it at most
// Scatter between windows over that between shorter blocks: the 1 % point for a dozen windows. Beyond it what drives
// the rig has noise that a resonance stretches all over a window, small as its share of the whole residual may be.
constexpr double kResembles = 1.5;

struct Normal {              // of one window
  Mat states_inverse_cross;  // what a change of the parameters does to the state
  Vec state_step;
  Mat state_gram, cross;  // of the state, in units of state_scale; with the parameters
  Vec state_scale, state_right;
  Mat gram;
  Vec score;
  Vec ss;
  Vec residual;                 // while blocks are asked for
  std::vector<Mat> block_gram;  // where blocks are asked for
  std::vector<Vec> block_score, block_ss;
};

struct Pass {
  bool ok = false;
  std::vector<Normal> windows;
  Vec mean_square;
  double cost = 0, memory = 1;
};

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

// parts: blocks that each window is divided into; 0: none are asked for. The windows side by side, what they sum up to in order.
Pass pass_over(Evaluator& evaluator, const std::vector<Window>& windows, const Vec* weights, bool slopes,
               size_t parts = 0) {
  Pass pass;
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

// How a window's state moves beside a change of the parameters. Damped: what the window hardly determines stays near where it was.
Vec state_change(const Normal& n, const Vec& change, double damping) {
  if (damping == 0) return n.state_step - n.states_inverse_cross * change;
  Mat a = n.state_gram;
  a.diagonal().array() += damping;
  return n.state_scale.asDiagonal() * a.llt().solve(n.state_scale.asDiagonal() * (n.state_right - n.cross * change));
}

void step_parameters(Model& model, const Vec& change) {
  const std::vector<Parameter> parameters = parameters_of(model);
  for (size_t i = 0; i < parameters.size(); ++i) {
    ModelTerm& t = model[parameters[i].term];
    const double d = change[static_cast<Index>(i)];
    if (parameters[i].shape == 2) {
      const double step = std::clamp(d, -kLongestStep, kLongestStep);
      t.term.kind == Kind::kCogging ? t.term.shape2 += step : t.term.shape2 *= std::exp(step);
    } else if (parameters[i].shape) {
      t.term.shape *= std::exp(std::clamp(d, -kLongestStep, kLongestStep));
    } else {
      const double next = t.value + d;
      t.value = positive(t.term.kind) && t.value > 0 ? std::max(next, kLeastShare * t.value) : next;
    }
  }
}

// Weighted square sum of a window's residual; huge where its run does not stay finite.
double error_of(Evaluator& evaluator, const Vec& weights, const Window& w, WindowRun& run, size_t lane = 0) {
  if (!evaluator.run(w, false, false, run, lane)) return 1e300;
  double sum = 0;
  for (Index c = 0; c < weights.size(); ++c)
    sum += run.residual.segment(c * w.length, w.length).squaredNorm() * weights[c] * weights[c];
  return sum;
}

// Windows that a step led astray, as one does that starts at rest and hardly determines its state: they would hold all others
// back. Beside given parameters each window is on its own: those that are worse than before go a damped way instead, or stay,
// whichever leaves the least. True where any had left the motion altogether.
bool shorter_ways(Evaluator& evaluator, const Pass& now, const Pass& next, const Vec& change, const Vec& weights,
                  const std::vector<Window>& windows, std::vector<Window>& moved) {
  std::atomic<bool> any{false};
  std::vector<WindowRun> runs(lanes());
  in_parallel(windows.size(), [&](size_t i, size_t lane) {
    const double before = now.windows[i].ss.dot(weights.cwiseAbs2());
    double least = next.ok ? next.windows[i].ss.dot(weights.cwiseAbs2())
                           : error_of(evaluator, weights, moved[i], runs[lane], lane);
    if (least > kAstray * before) any = true;
    for (const bool damped : {true, false}) {
      if (least <= before) break;
      Window other = windows[i];
      if (damped) evaluator.moved(other, state_change(now.windows[i], change, kAstrayDamping), other.state);
      const double error = error_of(evaluator, weights, other, runs[lane], lane);
      if (error < least) least = error, moved[i] = other;
    }
  });
  return any;
}

// A state fitted beside another model may lie where this one does not come back from (a damping that falls with the rate): such a
// window starts from the measured motion, or from rest. True where any does.
bool started_afresh(Evaluator& evaluator, std::vector<Window>& windows) {
  std::atomic<bool> any{false};
  std::vector<WindowRun> runs(lanes());
  in_parallel(windows.size(), [&](size_t i, size_t lane) {
    Window& w = windows[i];
    const auto finite = [&] { return evaluator.run(w, false, false, runs[lane], lane); };
    if (finite()) return;
    any = true;
    w.state.resize(0), w.state = evaluator.carried_state(w);
    if (!finite()) w.state.setZero();
  });
  return any;
}

bool has_friction(const Model& model) {
  return std::any_of(model.begin(), model.end(), [](const ModelTerm& t) {
    return t.term.kind == Kind::kCoulomb || t.term.kind == Kind::kMissingCoulomb;
  });
}

// Dry friction makes valleys of a window's error: where a link sticks the first guess of its state leads elsewhere.
// The run from where the window before ended, or from rest where none is before it, may lie in the right one. True
// where any window took such a state.
bool carried_on(Evaluator& evaluator, const Vec& weights, std::vector<Window>& windows) {
  bool any = false;
  WindowRun before, own, other;
  for (size_t i = 0; i < windows.size(); ++i) {
    const double error = error_of(evaluator, weights, windows[i], own);
    const bool follows = i > 0 && windows[i - 1].record == windows[i].record &&
                         windows[i - 1].from + windows[i - 1].length == windows[i].from;
    Window w = windows[i];
    if (!follows)
      w.state.setZero();
    else if (before.end.size())
      w.state = before.end;
    if (error_of(evaluator, weights, w, other) < kPays * error) windows[i] = w, std::swap(own, other), any = true;
    std::swap(before, own);
  }
  return any;
}

}  // namespace

double normal_deviate(double t, double dof) {  // Wallace 1959
  const double z = std::sqrt(dof * std::log1p(t * t / dof)) * (8 * dof + 1) / (8 * dof + 3);
  return t < 0 ? -z : z;
}

namespace {

// Beside given numbers the states of windows alone are free.
Model with_nothing_free(Model model) {
  for (ModelTerm& t : model) t.known = true, t.shape_free = t.shape2_free = false;
  return model;
}

// A model on its way to the least cost. What a step leaves is known from runs without slopes, which are many times cheaper; slopes
// are made where another step is to follow.
class Descent {
 public:
  Descent(const System& system, const std::vector<Prepared>& records, Model& model, std::vector<Window>& windows,
          bool only_states)
      : system_(system), records_(records), model_(model), windows_(windows), only_states_(only_states) {
    evaluator_ = std::make_unique<Evaluator>(system, model, records);
  }
  // False where the model cannot run the windows.
  bool start() {
    if (!evaluator_->sound()) return false;
    for (Window& w : windows_) w.state = evaluator_->carried_state(w);
    now_ = pass_over(*evaluator_, windows_, nullptr, false);
    if (!now_.ok && started_afresh(*evaluator_, windows_)) now_ = pass_over(*evaluator_, windows_, nullptr, false);
    if (now_.ok) weights_ = weights_of_slopes_ = weights_now();
    return now_.ok;
  }
  // Until a step brings nothing; false where slopes do not stay finite.
  bool go_on(int iterations) {
    damping_ = 1e-4;
    for (int i = 0; i < iterations; ++i) {
      if (!sloped_ && !make_slopes()) return false;
      if (step() < kSettled) break;
    }
    return true;
  }
  // Whether windows took states that may lie in lower valleys.
  bool carry_on() {
    if (!has_friction(model_) || !carried_on(*evaluator_, weights_, windows_)) return false;
    weights_of_slopes_ = weights_, sloped_ = false;
    return true;
  }
  const Vec& weights() const { return weights_; }
  size_t passes() const { return passes_; }

 private:
  Vec weights_now() const { return now_.mean_square.cwiseSqrt().cwiseInverse(); }
  bool make_slopes() {
    now_ = pass_over(*evaluator_, windows_, &weights_of_slopes_, true), ++passes_;
    return sloped_ = now_.ok;
  }
  Vec change_of(const Mat& gram, const Vec& score) const {
    const Vec scale = gram.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    Mat a = scale.asDiagonal() * gram * scale.asDiagonal();
    a.diagonal().array() += damping_;
    return scale.asDiagonal() * a.ldlt().solve(scale.asDiagonal() * score);
  }
  // By how much the cost falls; nought where there is no way down.
  double step() {
    const Index p = evaluator_->parameters();
    Mat gram = Mat::Zero(p, p);
    Vec score = Vec::Zero(p);
    for (const Normal& n : now_.windows) gram += n.gram, score += n.score;
    for (int attempt = 0; attempt < (p > 0 ? kTries : 1); ++attempt) {
      const std::optional<double> fall = taken(p > 0 ? change_of(gram, score) : score);
      if (fall) return *fall;
      damping_ = std::max(1e-3, damping_ * 30);
    }
    return 0;
  }
  // Goes that way where it leads down, and tells by how much.
  std::optional<double> taken(const Vec& change) {
    Model trial = model_;
    step_parameters(trial, change);
    std::vector<Window> moved = windows_;
    const auto other = change.size() ? std::make_unique<Evaluator>(system_, trial, records_) : nullptr;
    Evaluator& evaluator = other ? *other : *evaluator_;
    if (!evaluator.sound()) return std::nullopt;
    const bool runs = !evaluator_->massless();
    for (size_t w = 0; runs && w < windows_.size(); ++w)
      evaluator.moved(moved[w], state_change(now_.windows[w], change, 0), moved[w].state);
    Pass next = pass_over(evaluator, moved, nullptr, false);
    bool whole = true;
    if (runs && (!next.ok || next.cost >= now_.cost)) {
      whole = !shorter_ways(evaluator, now_, next, change, weights_, windows_, moved);
      next = pass_over(evaluator, moved, nullptr, false);
    }
    if (!next.ok || !(next.cost < now_.cost + 1e-9 * std::abs(now_.cost))) return std::nullopt;
    // where some did not move there may be more to gain
    const double fall = whole || only_states_ ? now_.cost - next.cost : kSettled;
    model_ = trial, windows_ = moved, now_ = std::move(next), sloped_ = false;
    if (other) evaluator_ = std::make_unique<Evaluator>(system_, model_, records_);
    weights_of_slopes_ = weights_, weights_ = weights_now();
    damping_ = std::max(1e-6, damping_ / 10);
    return fall;
  }

  const System& system_;
  const std::vector<Prepared>& records_;
  Model& model_;
  std::vector<Window>& windows_;
  const bool only_states_;
  std::unique_ptr<Evaluator> evaluator_;
  Pass now_;
  bool sloped_ = false;
  size_t passes_ = 0;
  Vec weights_, weights_of_slopes_;
  double damping_ = 1e-4;
};

// The weights that the channels have in the end; none where it leads nowhere. passes: that it took, with slopes.
Vec descended(const System& system, const std::vector<Prepared>& records, Model& model, std::vector<Window>& windows,
              int iterations, bool only_states, size_t& passes) {
  Model held;
  if (only_states) held = with_nothing_free(model);
  if (windows.empty() || (only_states && massless(held) != massless(model))) return {};
  Descent way(system, records, only_states ? held : model, windows, only_states);
  if (!way.start() || !way.go_on(iterations) || (way.carry_on() && !way.go_on(iterations))) return {};
  passes = way.passes();
  return way.weights();
}

}  // namespace

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
  Pass now = pass_over(evaluator, windows, &weights, true, out.parts);
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
double student_std(const Scatter& s) { return s.se * quantile(boost::math::students_t(s.dof), 0.975) / 1.96; }

}  // namespace

std::vector<Determined> determined(const Fitted& fit, const Model& model) {
  const std::vector<Parameter> parameters = parameters_of(model);
  const Index p = static_cast<Index>(parameters.size());
  std::vector<Determined> list(parameters.size());
  if (p == 0 || fit.gram.empty()) return list;
  Mat total = Mat::Zero(p, p);
  for (const Mat& g : fit.gram) total += g;
  const size_t forgotten = static_cast<size_t>(
      std::clamp(kForgotten * fit.memory / fit.block_length + 1, 1.0, static_cast<double>(fit.parts)));
  std::vector<bool> none(parameters.size(), false), shapes = none;
  for (size_t i = 0; i < parameters.size(); ++i) shapes[i] = parameters[i].shape != 0;
  const Mat inverse = inverse_of(total, none), at_this_shape = inverse_of(total, shapes);
  for (Index i = 0; i < p; ++i) {
    const size_t k = static_cast<size_t>(i);
    Determined& d = list[k];
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
    if (std::abs(d.z) > kSure && std::abs(model[parameters[k].term].value) < 1.96 * d.std) d.std = student_std(s);
  }
  return list;
}

}  // namespace diagnosis::runs
