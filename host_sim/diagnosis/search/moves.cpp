// Terms that join a model, leave it and take each other's place.
#include "moves.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis {
namespace {

constexpr double kLeastGain = 17;  // of chi-squared, for two terms in place of one
constexpr double kLeftOver = 1.1;  // chi-squared per degree of freedom that says a shape is not met
constexpr size_t kTried = 4;

bool shaped_on(const std::vector<ActiveTerm>& model, int link) {
  for (const ActiveTerm& t : model)
    if (t.added && link >= 0 && t.term.link == link && CandidateBank::has_shape(t.term)) return true;
  return false;
}

}  // namespace

bool Moves::extend(State& state, double least_gain, size_t beam) {
  const std::vector<Found> list = ranked(rows_, bank_, state.model, state.fit, 5);
  State best;
  bool found = false;
  double cost = 0, leading = 0;  // score of the first that passes
  size_t tried = 0;
  for (const Found& f : list) {
    if (f.score < f.candidate.needed(f.gain.std) || f.gain.chi2 < least_gain) continue;
    leading = std::max(leading, f.score);
    if (f.score < 0.4 * leading || ++tried > beam) break;
    State trial = settled(joined(state.model, f.candidate, f.gain), 2);
    if (!plausible(trial.model)) continue;
    if (list.size() > 1 && list[1].score > 0.4 * list[0].score) polish(trial);
    const double trial_cost = trial.fit.chi2 + f.candidate.penalty * std::max(1.0, trial.fit.ratio());
    if (!found || trial_cost < cost) best = trial, cost = trial_cost, found = true;
  }
  if (found) {
    state = best;
    polish(state);
  }
  state.fit = settle(rows_, state.model, 1);
  return found;
}

bool Moves::extend_beside_reversals(State& state, double least_gain) {
  const bool found = extend_wide(state, least_gain);
  if (found) polish(state);
  state.fit = settle(rows_, state.model, 1);
  return found;
}

bool Moves::extend_wide(State& state, double least_gain) {
  const Rows::Look look(rows_, Rows::Reversals::kWide);
  const State wide = settled(state.model, 2);
  for (const Found& f : ranked(rows_, bank_, wide.model, wide.fit, 3)) {
    if (CandidateBank::friction_shape(f.candidate.term().kind)) continue;
    if (f.score < f.candidate.needed(f.gain.std) || f.gain.chi2 < least_gain) continue;
    const State best = settled(joined(wide.model, f.candidate, f.gain), 2);
    if (!plausible(best.model)) return false;
    state = best;
    return true;
  }
  return false;
}

bool Moves::holds_beside_reversals(const State& state, size_t index) {
  if (CandidateBank::friction_shape(state.model[index].term.kind)) return false;
  const bool holds = holds_wide(state, index);
  settled(state.model, 1);
  return holds;
}

bool Moves::holds_wide(const State& state, size_t index) {
  const Rows::Look look(rows_, Rows::Reversals::kWide);
  const State wide = settled(state.model, 2), w = without(wide, index);
  const Candidate c = bank_.again(state.model[index].term, w.model);
  return (w.fit.chi2 - wide.fit.chi2 - c.penalty) / std::max(1.0, wide.fit.ratio()) >= c.needed(wide.model[index].std);
}

bool Moves::swap(State& state) {
  bool changed = false;
  for (size_t k = 0; k < added_terms(state.model).size(); ++k) {
    const size_t index = added_terms(state.model)[k];
    const Term mine = state.model[index].term;
    const State base = without(state, index);
    const std::vector<Found> list = ranked(rows_, bank_, base.model, base.fit, 3);
    const bool left = state.fit.ratio() > kLeftOver && shaped_on(base.model, mine.link);
    for (size_t i = 0; i < list.size() && i < (left ? kTried : 1); ++i) {
      const bool same = list[i].candidate.term().same_place(mine);
      if (same && !left) break;
      State trial = settled(joined(base.model, list[i].candidate, list[i].gain), 2);
      left ? polish_together(trial) : polish(trial);
      if (!plausible(trial.model) || trial.fit.chi2 >= state.fit.chi2 - 4) continue;
      state = trial;
      changed = changed || !same;
    }
    state.fit = settle(rows_, state.model, 1);
  }
  return changed;
}

bool Moves::merge(State& state) {
  const std::vector<size_t> terms = added_terms(state.model);
  for (size_t i = 0; i < terms.size(); ++i)
    for (size_t j = i + 1; j < terms.size(); ++j)
      if (merge_pair(state, terms[i], terms[j])) return true;
  return false;
}

bool Moves::merge_pair(State& state, size_t first, size_t second) {
  const double noise = std::max(1.0, state.fit.ratio()), least = state.fit.chi2 + kLeastGain * noise;
  const Term a = state.model[first].term, b = state.model[second].term;
  const bool bends = CandidateBank::friction_shape(a.kind), one_link = a.link >= 0 && a.link == b.link;
  const Term shape = bends ? a : b;
  const double shape_gain = without(state, bends ? first : second).fit.chi2 - state.fit.chi2;
  const State base = without(without(state, second), first);
  const std::vector<Found> list = ranked(rows_, bank_, base.model, base.fit, 4);
  State best;
  double cost = 0;
  bool found = false;
  for (size_t k = 0; k < list.size() && k < 4; ++k) {
    const Term& term = list[k].candidate.term();
    State trial = settled(joined(base.model, list[k].candidate, list[k].gain), 1);
    polish(trial);
    if (CandidateBank::friction_shape(term.kind)) settle_friction_shapes(trial);
    const double trial_cost = trial.fit.chi2 + list[k].candidate.penalty * noise;
    const bool beside_shape = one_link && term.same_place(shape) && CandidateBank::friction_shape(term.kind);
    const double most = std::max(least, beside_shape ? state.fit.chi2 + kLeastBesideFriction * shape_gain : 0.0);
    if (plausible(trial.model) && trial_cost < most && (!found || trial_cost < cost))
      best = trial, cost = trial_cost, found = true;
  }
  if (found) state = best;
  state.fit = settle(rows_, state.model, 1);
  return found;
}

}  // namespace diagnosis
