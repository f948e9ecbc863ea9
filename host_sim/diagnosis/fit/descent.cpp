#include "descent.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <memory>
#include <optional>

#include "window_states.hpp"

namespace diagnosis::runs {
namespace {

constexpr int kTries = 5;          // of a step, each damped more
constexpr int kStateSteps = 3;     // of the states beside a step of the numbers that misleads them
constexpr double kSettled = 0.02;  // of the cost: a fall that no test can notice

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
