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

std::vector<size_t> added_terms(const std::vector<ActiveTerm>& model) {
  std::vector<size_t> list;
  for (size_t i = 0; i < model.size(); ++i)
    if (model[i].added) list.push_back(i);
  return list;
}

State Moves::settled(std::vector<ActiveTerm> model, int rounds) {
  State s{std::move(model), {}};
  s.fit = settle(rows_, s.model, rounds);
  return s;
}

State Moves::without(const State& state, size_t index) {
  State w{state.model, {}};
  remove_term(w.model, index);
  w.fit = fit_model(rows_, w.model);
  return w;
}

void Moves::polish(State& state) {
  for (size_t k = 0; k < added_terms(state.model).size(); ++k) {
    const size_t index = added_terms(state.model)[k];
    const Term term = state.model[index].term;
    if (!CandidateBank::has_shape(term)) continue;
    const State w = without(state, index);
    const Scorer scorer{rows_, bank_, w.model, w.fit};
    const Found best = scorer.polished(scorer.of(bank_.again(term, w.model)));
    State trial = settled(joined(w.model, best.candidate, best.gain), 1);
    if (trial.fit.cost < state.fit.cost) state = trial;
    else state.fit = settle(rows_, state.model, 1);
  }
}

void Moves::settle_friction_shape(State& state, size_t index, Axis axis) {
  const auto reshaped = [&](double logarithm) {
    const Term t = moved(state.model[index].term, axis, logarithm);
    State trial = state;
    ActiveTerm& active = trial.model[index];
    active.column = bank_.reshaped({active.column, {}}, t.shape, t.shape2).column;
    active.term = active.column->term, active.force.reset();
    trial.fit = settle(rows_, trial.model, 2);
    return trial;
  };
  const auto within = [](double value, const CandidateBank::Range& r) { return value > r.low && value < r.high; };
  double step = 0.4;
  for (int i = 0; i < 7; ++i) {  // downhill, in smaller steps where neither side is better
    bool better = false;
    for (double way : {step, -step}) {
      const Term t = moved(state.model[index].term, axis, way);
      if (!within(t.shape, bank_.range(t))) continue;
      const State trial = reshaped(way);
      if (trial.fit.cost >= state.fit.cost || !plausible(trial.model)) continue;
      state = trial, better = true;
      break;
    }
    if (!better) step *= 0.4;
  }
}

void Moves::settle_friction_shapes(State& state) {
  for (size_t index : added_terms(state.model)) {
    const Term term = state.model[index].term;
    if (!CandidateBank::friction_shape(term.kind)) continue;
    if (term.shape2 > 0)
      for (Axis axis : {Axis::kBoth, Axis::kSecond}) settle_friction_shape(state, index, axis);
    settle_friction_shape(state, index, Axis::kFirst);
  }
  state.fit = settle(rows_, state.model, 1);
}

bool Moves::extend(State& state, double least_gain, size_t beam) {
  const std::vector<Found> list = ranked(rows_, bank_, state.model, state.fit, 5);
  State best;
  bool found = false;
  double cost = 0, leading = 0;  // score of the first that passes
  size_t tried = 0;
  for (const Found& f : list) {
    if (f.score < f.candidate.threshold || f.gain.chi2 < least_gain) continue;
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
    if (f.score < f.candidate.threshold || f.gain.chi2 < least_gain) continue;
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
  return (w.fit.chi2 - wide.fit.chi2 - c.penalty) / std::max(1.0, wide.fit.ratio()) >= c.threshold;
}

// Shapes on one link answer to each other: in turns until neither gains.
void Moves::polish_together(State& state) {
  for (int round = 0; round < 5; ++round) {
    const double before = state.fit.cost;
    polish(state);
    if (state.fit.cost > before - 10) break;
  }
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
    for (size_t j = i + 1; j < terms.size(); ++j) {
      State base = without(state, terms[j]);
      base = without(base, terms[i]);
      const std::vector<Found> list = ranked(rows_, bank_, base.model, base.fit, 4);
      const double noise = std::max(1.0, state.fit.ratio());
      State best;
      double cost = state.fit.chi2 + kLeastGain * noise;
      bool found = false;
      for (size_t k = 0; k < list.size() && k < 4; ++k) {
        State trial = settled(joined(base.model, list[k].candidate, list[k].gain), 1);
        polish(trial);
          if (CandidateBank::friction_shape(list[k].candidate.term().kind)) settle_friction_shapes(trial);
        const double trial_cost = trial.fit.chi2 + list[k].candidate.penalty * noise;
        if (plausible(trial.model) && trial_cost < cost) best = trial, cost = trial_cost, found = true;
      }
      if (found) {
        state = best;
        state.fit = settle(rows_, state.model, 1);
        return true;
      }
      state.fit = settle(rows_, state.model, 1);
    }
  return false;
}

}  // namespace diagnosis
