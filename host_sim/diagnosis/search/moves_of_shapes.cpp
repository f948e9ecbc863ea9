// A model fitted, and the shapes of its added terms.
#include <algorithm>
#include <cmath>
#include <utility>

#include "moves.hpp"

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
    if (!CandidateBank::bends(term)) continue;
    const State w = without(state, index);
    const Scorer scorer{rows_, bank_, w.model, w.fit};
    const Found best = scorer.polished(scorer.of(bank_.again(term, w.model)));
    State trial = settled(joined(w.model, best.candidate, best.gain), 1);
    if (trial.fit.cost < state.fit.cost)
      state = trial;
    else
      state.fit = settle(rows_, state.model, 1);
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

std::optional<State> Moves::reshaped(const State& state, size_t index, const Term& t) {
  const CandidateBank::Range range = bank_.range(t);
  if (t.shape <= range.low || t.shape >= range.high) return std::nullopt;
  State trial = state;
  ActiveTerm& active = trial.model[index];
  active.column = bank_.reshaped({active.column, {}}, t.shape, t.shape2).column;
  active.term = active.column->term, active.force.reset();
  trial.fit = settle(rows_, trial.model, 2);
  if (!plausible(trial.model)) return std::nullopt;
  return trial;
}

// Downhill until both neighbours are worse, then to the lowest point of the parabola through the three; twice.
void Moves::settle_friction_shape(State& state, size_t index, Axis axis) {
  const auto beside = [&](double logarithm) {
    return reshaped(state, index, moved(state.model[index].term, axis, logarithm));
  };
  for (double step : {0.3, 0.06}) {
    std::optional<State> below = beside(-step), above = beside(step);
    for (int i = 0; i < 6; ++i) {
      if (above && above->fit.cost < state.fit.cost)
        below = std::exchange(state, *above), above = beside(step);
      else if (below && below->fit.cost < state.fit.cost)
        above = std::exchange(state, *below), below = beside(-step);
      else
        break;
    }
    if (!below || !above) continue;
    const double fall = below->fit.cost - state.fit.cost, rise = above->fit.cost - state.fit.cost;
    if (!(fall + rise > 0) || fall < 0 || rise < 0) continue;
    const std::optional<State> lowest = beside(0.5 * step * (fall - rise) / (fall + rise));
    if (lowest && lowest->fit.cost < state.fit.cost) state = *lowest;
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
