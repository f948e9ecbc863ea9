#include "window_states.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <atomic>

#include "error_rates.hpp"
#include "in_parallel.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kAstrayDamping = 1e-3;  // of the state of a window that its step led astray, in units of its columns
constexpr double kAstray = 100;          // times a window's error before its step: it has left the motion altogether

// Weighted square sum of a window's residual; huge where its run does not stay finite.
double error_of(Evaluator& evaluator, const Vec& weights, const Window& w, WindowRun& run, size_t lane = 0) {
  if (!evaluator.run(w, false, false, run, lane)) return 1e300;
  double sum = 0;
  for (Index c = 0; c < weights.size(); ++c)
    sum += run.residual.segment(c * w.length, w.length).squaredNorm() * weights[c] * weights[c];
  return sum;
}

}  // namespace

Vec state_change(const Normal& n, const Vec& change, double damping) {
  if (damping == 0) return n.state_step - n.states_inverse_cross * change;
  Mat a = n.state_gram;
  a.diagonal().array() += damping;
  return n.state_scale.asDiagonal() * a.llt().solve(n.state_scale.asDiagonal() * (n.state_right - n.cross * change));
}

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

}  // namespace diagnosis::runs
