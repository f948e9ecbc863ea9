#include "attempt.hpp"

#include <algorithm>
#include <cmath>

#include "bristles.hpp"
#include "judge.hpp"
#include "merit.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kSmallStart = 0.3;  // of the value that the linearisation gives
constexpr double kPromised = 0.8;    // of the linearisation's gain, that a fit should reach
constexpr int kFirstSteps = 3;       // with shapes held
// Times what a cause that stands leaves: what promises no more than this is not looked for in further valleys.
constexpr double kFarBehind = 2;

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

// From a coefficient of nought the first step brings all numbers into balance; what has states of its own starts small.
std::vector<double> first_values(const Candidate& c, const Screened& one) {
  if (c.terms[0].kind == Kind::kCogging) return one.value;  // its phase too
  std::vector<double> start(c.terms.size(), 0.0);
  if (c.terms[0].kind == Kind::kResonance) start[0] = kSmallStart * one.value[0];
  return start;
}

Attempt first_attempt(const Task& task, const State& beside, const std::vector<Candidate>& all, const Screened& one) {
  const Candidate& c = all[one.candidate];
  return attempt(task, beside, {c}, {first_values(c, one)}, kTrialSteps);
}

// Short of what the linearisation promises, which would be worth having.
bool stuck(const Attempt& a, const Screened& one, double noise) {
  return 1 - a.error < kPromised * one.gain && !hopeless(one.gain, 1, noise);
}

// Stuck on the way: from where the linearisation points, and from the measured motion.
Attempt again(const Task& task, const State& beside, const std::vector<Candidate>& all, const Screened& one,
              Attempt a) {
  const Candidate& c = all[one.candidate];
  const auto try_again = [&](const Candidate& other, const std::vector<double>& value) {
    Attempt another = attempt(task, beside, {other}, {value}, kTrialSteps, From::kMeasured);
    const bool usable = a.state.fit.ok && !a.rounds;
    if (another.state.fit.ok && (!usable || whole_error(another) < whole_error(a))) a = std::move(another);
  };
  if (c.host < 0) {
    try_again(c, one.value);
    return a;
  }
  for (const Candidate& o : all)  // what acts in another's place has its full size at once: not every shape leads home
    if (o.same_place(c)) try_again(o, first_values(c, one));
  return a;
}

}  // namespace

Attempt attempt(const Task& task, const State& beside, const std::vector<Candidate>& all, const Screened& one,
                double noise) {
  Attempt a = first_attempt(task, beside, all, one);
  if (stuck(a, one, noise)) a = again(task, beside, all, one, std::move(a));
  return is_bristles(a) ? damped(task, beside, a) : a;
}

std::vector<Attempt> attempts(const Task& task, const State& beside, const std::vector<Candidate>& all,
                              const std::vector<Screened>& list, double noise, double least, const Stands& stands) {
  std::vector<Attempt> tried =
      side_by_side(list.size(), [&](size_t i) { return first_attempt(task, beside, all, list[i]); });
  for (const Attempt& a : tried)
    if (stands && a.state.fit.ok && !a.rounds && whole_error(a) < least && stands(a)) least = whole_error(a);
  in_parallel(list.size(), [&](size_t i, size_t) {
    Attempt& a = tried[i];
    if (stuck(a, list[i], noise) && 1 - list[i].gain < kFarBehind * least)
      a = again(task, beside, all, list[i], std::move(a));
    if (is_bristles(a) && whole_error(a) < kFarBehind * least) a = damped(task, beside, a);
  });
  return tried;
}

void keep_shape(const Model& fitted, Candidate& c) {
  for (const ModelTerm& t : fitted)
    if (t.added && t.term.same_place(c.terms[0])) c.terms = {t.term};
}

}  // namespace diagnosis::runs
