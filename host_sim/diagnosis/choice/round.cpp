#include "round.hpp"

#include <algorithm>
#include <cmath>

#include "../doubts/possible.hpp"
#include "../trial/bristles.hpp"
#include "../trial/merit.hpp"
#include "../trial/pairs.hpp"

namespace diagnosis::runs {
namespace {

// Whether a simpler cause leaves no more than what each of its fewer numbers is worth.
bool as_good(const Attempt& simpler, const Attempt& best, double worth) {
  return whole_error(simpler) < whole_error(best) * std::pow(worth, best.complexity - simpler.complexity);
}

// An effect that leaves less of what the fit has seen and of what it has not, by as much as a cause has to.
void keep_nearest(const Task& task, const State& now, const std::vector<Attempt>& tried, double noise, Choice& choice) {
  for (const Attempt& t : tried) {
    if (!t.state.fit.ok || t.rounds || std::max(t.error, t.unseen) > 1 - kShare) continue;
    if (!can_stand(task, now, t)) continue;
    const Nearly found{t.candidates[0], t.state.model, share_of(t, noise)};
    if (!choice.nearest || found.share > choice.nearest->share) choice.nearest = found;
  }
}

// Where filters round the jumps of friction (`rounded`), damping laws that change with the rate look like that: they have to be there
// beside it too.
bool stands(const Beside& b, const State& rounded, const Attempt& t) {
  if (!passes(t, b.already, b.noise) || t.unresolved) return false;
  if (!rounded.fit.ok || whole_error(t) < error_over(rounded.fit, b.now.fit)) return true;
  const std::vector<std::vector<double>> start(t.candidates.size(), {0.0});
  const double left_noise = std::min(1.0, b.noise / error_over(rounded.fit, b.now.fit));
  return passes(attempt(b.task, rounded, t.candidates, start, kTrialSteps), b.already, left_noise);
}

// What does the work of a number of the rig, puts energy in, or may be nought, comes behind what does not.
void take_single(const Beside& b, const State& rounded, const std::vector<Attempt>& singles, double worth,
                 Round& round) {
  const auto standing = [&](const Attempt& t) { return stands(b, rounded, t); };
  auto first = std::find_if(singles.begin(), singles.end(),
                            [&](const Attempt& t) { return standing(t) && can_stand(b.task, b.now, t); });
  if (first == singles.end()) first = std::find_if(singles.begin(), singles.end(), standing);
  if (first == singles.end()) return;
  round.best = *first, round.found = true;
  for (auto t = first + 1; t < singles.end(); ++t)  // the other is its rival
    if (t->complexity < round.best.complexity && as_good(*t, *first, worth) && standing(*t)) round.best = *t;
  for (const Attempt& t : singles) {
    if (!t.state.fit.ok || t.rounds || t.candidates[0].same_place(round.best.candidates[0])) continue;
    if (whole_error(t) > worth * whole_error(round.best)) continue;
    round.passed_over.push_back(t.candidates[0]);
    keep_shape(t.state.model, round.passed_over.back());
  }
}

// Two that help only together: where no single does, or where they leave half of what the best single does.
void take_pair(const Beside& b, const State& rounded, const std::vector<Attempt>& pairs, Round& round) {
  const Attempt* best = nullptr;
  for (const Attempt& t : pairs) {
    if (!stands(b, rounded, t)) continue;
    const bool better = best && (t.complexity == best->complexity ? whole_error(t) < whole_error(*best)
                                                                  : clearly_better(t, *best, b.noise));
    if (!best || better) best = &t;
  }
  if (best && (!round.found || whole_error(*best) < 0.5 * whole_error(round.best)))
    round.best = *best, round.found = true, round.passed_over.clear();
}

}  // namespace

Round round_of(const Task& task, const State& now, size_t already, const Left& left, double noise, double worth,
               Choice& choice) {
  choice.last_candidates = candidates_beside(task.system, now.model, task.records, left.worst() > kPlainlyLeft);
  choice.last_screen = screen(task.system, task.records, now.model, now.seen, now.fit, choice.last_candidates, kPairs);
  const Beside beside{task, now, already, noise, choice.last_candidates, choice.last_screen};
  Round round;
  std::vector<Attempt> singles = tried_singles(beside);
  round.stuck = own_friction_does(beside, singles, round.unstuck);
  if (round.stuck) return round;
  choice.nearly.clear();
  for (const Attempt& t : singles)
    if (nearly(t) && !t.unresolved) choice.nearly.push_back({t.candidates[0], t.state.model, share_of(t, noise)});
  if (already == 0) keep_nearest(task, now, singles, noise, choice);
  const State with_rounded_jumps = rounded(task, now, singles);
  take_single(beside, with_rounded_jumps, singles, worth, round);
  take_pair(beside, with_rounded_jumps, tried_pairs(beside, round.found ? &round.best : nullptr), round);
  return round;
}

}  // namespace diagnosis::runs
