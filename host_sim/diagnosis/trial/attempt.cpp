#include "attempt.hpp"

#include <algorithm>
#include <cmath>

#include "../fit/in_parallel.hpp"
#include "bristles.hpp"
#include "judge.hpp"
#include "merit.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kSmallStart = 0.3;  // of the value that the linearisation gives
constexpr double kPromised = 0.8;    // of the linearisation's gain, that a fit should reach
constexpr int kFirstSteps = 3;       // with shapes held

}  // namespace

Attempt attempt(const Task& task, const State& beside, const std::vector<Candidate>& candidates,
                const std::vector<std::vector<double>>& values, int steps, From from) {
  Attempt a;
  a.candidates = candidates;
  a.state.model = beside.model, a.state.seen = beside.seen, a.state.unseen = beside.unseen;
  if (from == From::kMeasured) forget_states(a.state);
  bool hosted = false;
  for (size_t i = 0; i < candidates.size(); ++i) {
    a.state.model = joined(a.state.model, candidates[i], values[i]);
    a.complexity += candidates[i].complexity, hosted = hosted || candidates[i].host >= 0;
  }
  if (from == From::kMeasured) approach(task.system, task.records, a.state.model, a.state.seen, steps, true);
  // shapes wait until their coefficients have a size
  const Model shapes = a.state.model;
  bool any_free = false;
  for (ModelTerm& m : a.state.model)
    if (m.added) any_free = any_free || m.shape_free || m.shape2_free, m.shape_free = m.shape2_free = false;
  if (any_free) approach(task.system, task.records, a.state.model, a.state.seen, kFirstSteps);
  for (size_t i = 0; i < shapes.size(); ++i)
    a.state.model[i].shape_free = shapes[i].shape_free, a.state.model[i].shape2_free = shapes[i].shape2_free;
  settle(task, a.state, steps);
  judge(task, beside, hosted, a);
  return a;
}

namespace {

Attempt undamped(const Task& task, const State& beside, const std::vector<Candidate>& all, const Screened& one,
                 double noise) {
  const Candidate& c = all[one.candidate];
  // From a coefficient of nought the first step brings all numbers into balance; what has states of its own starts
  // small.
  std::vector<double> start(c.terms.size(), 0.0);
  if (c.terms[0].kind == Kind::kResonance) start[0] = kSmallStart * one.value[0];
  if (c.terms[0].kind == Kind::kCogging) start = one.value;  // its phase too
  Attempt a = attempt(task, beside, {c}, {start}, kTrialSteps);
  if (1 - a.error >= kPromised * one.gain || hopeless(one.gain, 1, noise)) return a;
  // Stuck on the way: from where the linearisation points, and from the measured motion.
  const auto try_again = [&](const Candidate& other, const std::vector<double>& value) {
    Attempt again = attempt(task, beside, {other}, {value}, kTrialSteps, From::kMeasured);
    const bool usable = a.state.fit.ok && !a.rounds;
    if (again.state.fit.ok && (!usable || whole_error(again) < whole_error(a))) a = std::move(again);
  };
  if (c.host < 0) {
    try_again(c, one.value);
    return a;
  }
  for (const Candidate& o : all)  // what acts in another's place has its full size at once: not every shape leads home
    if (o.same_place(c)) try_again(o, start);
  return a;
}

}  // namespace

Attempt attempt(const Task& task, const State& beside, const std::vector<Candidate>& all, const Screened& one,
                double noise) {
  const Attempt a = undamped(task, beside, all, one, noise);
  return is_bristles(a) ? damped(task, beside, a) : a;
}

std::vector<Attempt> attempts(const Task& task, const State& beside, const std::vector<Candidate>& all,
                              const std::vector<Screened>& list, double noise) {
  std::vector<Attempt> tried(list.size());
  in_parallel(list.size(), [&](size_t i, size_t) { tried[i] = attempt(task, beside, all, list[i], noise); });
  return tried;
}

void keep_shape(const Model& fitted, Candidate& c) {
  for (const ModelTerm& t : fitted)
    if (t.added && t.term.same_place(c.terms[0])) c.terms = {t.term};
}

}  // namespace diagnosis::runs
