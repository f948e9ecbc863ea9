#include "descent.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <optional>

#include "error_rates.hpp"
#include "in_parallel.hpp"
#include "windows_pass.hpp"

namespace diagnosis::runs {
namespace {

constexpr int kTries = 5;                // of a step, each damped more
constexpr double kAstrayDamping = 1e-3;  // of the state of a window that its step led astray, in units of its columns
constexpr double kAstray = 100;          // times a window's error before its step: it has left the motion altogether
constexpr int kStateSteps = 3;           // of the states beside a step of the numbers that misleads them
constexpr double kSettled = 0.02;        // of the cost: a fall that no test can notice
constexpr double kLongestStep = 0.5;     // of a shape's logarithm
constexpr double kLeastShare = 0.3;      // of a positive number, that one step may leave of it

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
      t.value = positive(t.term.kind) && !t.corrects && t.value > 0 ? std::max(next, kLeastShare * t.value) : next;
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
bool shorter_ways(Evaluator& evaluator, const WindowsPass& now, const WindowsPass& next, const Vec& change,
                  const Vec& weights, const std::vector<Window>& windows, std::vector<Window>& moved) {
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
    return t.term.kind == Kind::kCoulomb || t.term.kind == Kind::kMissingCoulomb || t.term.kind == Kind::kStribeck;
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
    if (now_.ok) weights_ = weights_now();
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
    sloped_ = false;
    return true;
  }
  const Vec& weights() const { return weights_; }
  size_t passes() const { return passes_; }

 private:
  Vec weights_now() const { return now_.mean_square.cwiseSqrt().cwiseInverse(); }
  bool make_slopes() {
    now_ = pass_over(*evaluator_, windows_, &weights_, true), ++passes_;
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
      const std::optional<double> fall = taken(p > 0 ? change_of(gram, score) : score, attempt == 0);
      if (fall) return *fall;
      damping_ = std::max(1e-3, damping_ * 30);
    }
    return 0;
  }
  // Goes that way where it leads down, and tells by how much.
  std::optional<double> taken(const Vec& change, bool at_ease) {
    Model trial = model_;
    step_parameters(trial, change);
    std::vector<Window> moved = windows_;
    const auto other = change.size() ? std::make_unique<Evaluator>(system_, trial, records_) : nullptr;
    Evaluator& evaluator = other ? *other : *evaluator_;
    if (!evaluator.sound()) return std::nullopt;
    const bool runs = !evaluator_->massless();
    for (size_t w = 0; runs && w < windows_.size(); ++w)
      evaluator.moved(moved[w], state_change(now_.windows[w], change, 0), moved[w].state);
    WindowsPass next = pass_over(evaluator, moved, nullptr, false);
    bool whole = true;
    if (runs && (!next.ok || next.cost >= now_.cost)) {
      whole = !shorter_ways(evaluator, now_, next, change, weights_, windows_, moved);
      next = pass_over(evaluator, moved, nullptr, false);
    }
    // The numbers may be right and the states that go with them far from linear: beside friction that sticks.
    if (at_ease && change.size() && runs && next.ok && next.cost >= now_.cost && has_friction(trial)) {
      size_t passes = 0;
      descended(system_, records_, trial, moved, kStateSteps, true, passes);
      next = pass_over(evaluator, moved, nullptr, false);
    }
    if (!next.ok || !(next.cost < now_.cost + 1e-9 * std::abs(now_.cost))) return std::nullopt;
    // where some did not move there may be more to gain
    const double fall = whole || only_states_ ? now_.cost - next.cost : kSettled;
    model_ = trial, windows_ = moved, now_ = std::move(next), sloped_ = false;
    if (other) evaluator_ = std::make_unique<Evaluator>(system_, model_, records_);
    weights_ = weights_now();
    damping_ = std::max(1e-6, damping_ / 10);
    return fall;
  }

  const System& system_;
  const std::vector<Prepared>& records_;
  Model& model_;
  std::vector<Window>& windows_;
  const bool only_states_;
  std::unique_ptr<Evaluator> evaluator_;
  WindowsPass now_;
  bool sloped_ = false;
  size_t passes_ = 0;
  Vec weights_;
  double damping_ = 1e-4;
};

}  // namespace

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

}  // namespace diagnosis::runs
