#include "search.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis {
namespace {

constexpr double kLeastGain = 17;  // of chi-squared, for two terms in place of one
// What a later term must bring of the first one's gain: more where a shape was not met, most where it is friction's, which
// near reversals is known to a few percent only.
constexpr double kLeastShare = 0.0002, kLeastBesideShape = 0.0005, kLeastBesideFriction = 0.04;

struct State {  // a model, fitted
  std::vector<ActiveTerm> model;
  Fit fit;
  double penalty = 0;  // of its added terms' shapes
};

std::vector<size_t> added_terms(const std::vector<ActiveTerm>& model) {
  std::vector<size_t> list;
  for (size_t i = 0; i < model.size(); ++i)
    if (model[i].added) list.push_back(i);
  return list;
}

class Search {
 public:
  Search(Rows& rows, const CandidateBank& bank) : rows_(rows), bank_(bank) {}

  State settled(std::vector<ActiveTerm> model, int rounds) {
    State s{std::move(model), {}, 0};
    s.fit = settle(rows_, s.model, rounds);
    return s;
  }
  // The state without one added term, under the weights of the state itself.
  State without(const State& state, size_t index) {
    State w{state.model, {}, 0};
    remove_term(w.model, index);
    w.fit = fit_model(rows_, w.model);
    return w;
  }
  // Shapes of the added terms, each with the others in place.
  void polish(State& state) {
    for (size_t k = 0; k < added_terms(state.model).size(); ++k) {
      const size_t index = added_terms(state.model)[k];
      const Term term = state.model[index].term;
      if (!CandidateBank::has_shape(term.kind)) continue;
      const State w = without(state, index);
      const Scorer scorer{rows_, bank_, w.model, w.fit};
      const Found best = scorer.polished(scorer.of(bank_.again(term, w.model)));
      State trial = settled(joined(w.model, best.candidate, best.gain), 1);
      if (trial.fit.chi2 < state.fit.chi2) state = trial;
      else state.fit = settle(rows_, state.model, 1);
    }
  }
  // The best of the leading candidates once each is fitted and shaped in full.
  bool extend(State& state, double least_gain, size_t beam) {
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
  // The best candidate that shows away from velocity reversals, where little else disturbs it.
  bool extend_beside_reversals(State& state, double least_gain) {
    rows_.look_at(Rows::Reversals::kWide);
    State wide = settled(state.model, 2), best;
    bool found = false;
    for (const Found& f : ranked(rows_, bank_, wide.model, wide.fit, 3)) {
      if (CandidateBank::friction_shape(f.candidate.term().kind)) continue;
      if (f.score < f.candidate.threshold || f.gain.chi2 < least_gain) continue;
      best = settled(joined(wide.model, f.candidate, f.gain), 2);
      found = plausible(best.model);
      break;
    }
    rows_.look_at(Rows::Reversals::kNarrow);
    if (found) state = best, polish(state);
    state.fit = settle(rows_, state.model, 1);
    return found;
  }
  // What an added term brings where velocity reversals count for little, and what it must bring there.
  bool holds_beside_reversals(const State& state, size_t index) {
    const Term mine = state.model[index].term;
    if (CandidateBank::friction_shape(mine.kind)) return false;
    rows_.look_at(Rows::Reversals::kWide);
    const State wide = settled(state.model, 2), w = without(wide, index);
    const Candidate c = bank_.again(mine, w.model);
    const double score = (w.fit.chi2 - wide.fit.chi2 - c.penalty) / std::max(1.0, wide.fit.ratio());
    const bool holds = score >= c.threshold;
    rows_.look_at(Rows::Reversals::kNarrow);
    settled(state.model, 1);
    return holds;
  }
  // One round of exchanging each added term for the best in its place. True if a term changed.
  bool swap(State& state) {
    bool changed = false;
    for (size_t k = 0; k < added_terms(state.model).size(); ++k) {
      const size_t index = added_terms(state.model)[k];
      const Term mine = state.model[index].term;
      State trial = without(state, index);
      const std::vector<Found> list = ranked(rows_, bank_, trial.model, trial.fit, 3);
      if (list.empty() || list[0].candidate.term().same_place(mine)) continue;
      trial = settled(joined(trial.model, list[0].candidate, list[0].gain), 2);
      polish(trial);
      if (plausible(trial.model) && trial.fit.chi2 < state.fit.chi2 - 4) {
        state = trial;
        changed = true;
      }
      state.fit = settle(rows_, state.model, 1);
    }
    return changed;
  }
  // Two terms may stand for one that was passed over when it was their first's turn. True if one took their place.
  bool merge(State& state) {
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
  SearchResult run();

 private:
  bool review(State& state, SearchResult& result);
  Rows& rows_;
  const CandidateBank& bank_;
};

// Lists each added term with its gain and its rivals. False where one was not worth its place and has been removed.
bool Search::review(State& state, SearchResult& result) {
  result.added.clear(), result.rivals.clear();
  for (size_t index : added_terms(state.model)) {
    const Term mine = state.model[index].term;
    const State w = without(state, index);
    std::vector<Found> list = ranked(rows_, bank_, w.model, w.fit, 5);
    Found self = Scorer{rows_, bank_, w.model, w.fit}.of(bank_.again(mine, w.model));
    const double noise = std::max(1.0, state.fit.ratio());
    self.gain.chi2 = w.fit.chi2 - state.fit.chi2;
    self.score = (self.gain.chi2 - self.candidate.penalty) / noise;
    if (self.score < self.candidate.threshold && !holds_beside_reversals(state, index)) {
      remove_term(state.model, index);
      state.fit = settle(rows_, state.model, 2);
      return false;
    }
    self.gain.coefficient = state.model[index].value, self.gain.std = state.model[index].std;
    std::vector<Found> rivals;
    for (const Found& f : list)
      if (!f.candidate.term().same_place(mine) && (f.gain.chi2 - f.candidate.penalty) / noise > self.score - 12)
        rivals.push_back(f);
    result.added.push_back(self);
    result.rivals.push_back(rivals);
  }
  return true;
}

SearchResult Search::run() {
  SearchResult result;
  State state = settled(base_model(rows_), 3);
  result.base = state.model;
  result.base_fit = state.fit;
  const double start = state.fit.chi2;
  double first_gain = 0, least_share = kLeastShare;
  while (added_terms(state.model).size() < kMostTerms) {
    const double least_gain = least_share * first_gain;
    if (!extend(state, least_gain, 4) && !extend_beside_reversals(state, least_gain)) break;
    first_gain = std::max(first_gain, start - state.fit.chi2);
    for (size_t index : added_terms(state.model)) {
      const Kind kind = state.model[index].term.kind;
      if (CandidateBank::has_shape(kind))
        least_share = std::max(least_share, CandidateBank::friction_shape(kind) ? kLeastBesideFriction : kLeastBesideShape);
    }
    for (int i = 0; added_terms(state.model).size() > 1 && i < 3 && swap(state); ++i) {
    }
  }
  while (added_terms(state.model).size() > 1 && merge(state)) {
  }
  while (!review(state, result)) {
  }
  result.model = state.model;
  result.fit = state.fit;
  return result;
}

}  // namespace

SearchResult search(Rows& rows, const CandidateBank& bank) { return Search(rows, bank).run(); }

}  // namespace diagnosis
