// A model fitted, and the shapes of its added terms.
#include "moves.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis {

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

// Shapes on one link answer to each other: in turns until neither gains.
void Moves::polish_together(State& state) {
  for (int round = 0; round < 5; ++round) {
    const double before = state.fit.cost;
    polish(state);
    if (state.fit.cost > before - 10) break;
  }
}

void Moves::settle_friction_shape(State& state, size_t index, Axis axis) {
  const auto reshaped = [&](const Term& t) {
    State trial = state;
    ActiveTerm& active = trial.model[index];
    active.column = bank_.reshaped({active.column, {}}, t.shape, t.shape2).column;
    active.term = active.column->term, active.force.reset();
    trial.fit = settle(rows_, trial.model, 2);
    return trial;
  };
  double step = 0.4;
  for (int i = 0; i < 7; ++i) {  // downhill, in smaller steps where neither side is better
    bool better = false;
    for (double way : {step, -step}) {
      const Term t = moved(state.model[index].term, axis, way);
      const CandidateBank::Range range = bank_.range(t);
      if (t.shape <= range.low || t.shape >= range.high) continue;
      const State trial = reshaped(t);
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

}  // namespace diagnosis
