#include "settle.hpp"

#include <algorithm>

#include "../residual/motion_error.hpp"

namespace diagnosis::runs {
namespace {

// Where most of the residual is not noise the share of it and unseen data decide: chance is no rival, kSure is enough.
constexpr double kEnoughRows = 3000;  // samples of a part: some 60 periods
constexpr double kAsFound = 1.3;      // of the error over a part of the windows, that over all of them may be

}  // namespace

void settle(const Task& task, State& s, int steps) {
  s.fit = fit(task.system, task.records, s.model, s.seen, steps);
  if (!s.fit.ok) return;
  Model frozen = s.model;
  s.unseen_fit = fit(task.system, task.records, frozen, s.unseen, steps, true);
}

void forget_states(State& s) {
  for (std::vector<Window>* windows : {&s.seen, &s.unseen})
    for (Window& w : *windows) w.state.resize(0);
}

State part_of(const Task& task, const State& whole, double noise) {
  double rows = 0;
  for (const Window& w : whole.seen) rows += static_cast<double>(w.length);
  const size_t shortest = std::min(whole.seen.size(), 2 * whole.unseen.size());
  const size_t every = std::min(static_cast<size_t>(rows / kEnoughRows), shortest / (2 * kEnoughWindows));
  if (noise > kMostlyNoise || every < 2) return whole;
  State part;
  part.model = whole.model, part.noise = whole.noise;
  for (size_t i = 0; i < whole.seen.size(); i += every) part.seen.push_back(whole.seen[i]);
  for (size_t i = 0; i < whole.unseen.size(); i += every) part.unseen.push_back(whole.unseen[i]);
  settle(task, part, kTrialSteps);
  return part.fit.ok && part.unseen_fit.ok ? part : whole;
}

State on_all(const Task& task, const State& whole, const State& found) {
  State s = whole;
  s.model = found.model;
  if (found.seen.size() == whole.seen.size() && found.unseen.size() == whole.unseen.size())
    s.seen = found.seen, s.unseen = found.unseen;
  settle(task, s, kBaseSteps);
  if (s.fit.ok && motion_error(task, s) < kAsFound * motion_error(task, found)) return s;
  State measured = whole;
  measured.model = found.model;
  forget_states(measured);
  approach(task.system, task.records, measured.model, measured.seen, kBaseSteps,
           true);  // states first: one that is far off holds all back
  settle(task, measured, kBaseSteps);
  return measured.fit.ok && (!s.fit.ok || error_over(measured.fit, s.fit) < 1) ? measured : s;
}

}  // namespace diagnosis::runs
