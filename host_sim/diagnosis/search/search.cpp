#include "search.hpp"

#include <algorithm>
#include <cmath>

#include "moves.hpp"

namespace diagnosis {
namespace {

constexpr double kLeastShare = 0.00005, kLeastBesideShape = 0.0005;

// Lists each added term with its gain and its rivals. False where one was not worth its place and has been removed.
bool review(Rows& rows, const CandidateBank& bank, State& state, SearchResult& result) {
  Moves moves(rows, bank);
  result.added.clear(), result.rivals.clear();
  for (size_t index : added_terms(state.model)) {
    const Term mine = state.model[index].term;
    const State w = moves.without(state, index);
    std::vector<Found> list = ranked(rows, bank, w.model, w.fit, 5);
    Found self = Scorer{rows, bank, w.model, w.fit}.of(bank.again(mine, w.model));
    const double noise = std::max(1.0, state.fit.ratio());
    self.gain.chi2 = w.fit.chi2 - state.fit.chi2;
    self.score = (self.gain.chi2 - self.candidate.penalty) / noise;
    if (self.score < self.candidate.needed(state.model[index].std) && !moves.holds_beside_reversals(state, index)) {
      remove_term(state.model, index);
      state.fit = settle(rows, state.model, 2);
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

}  // namespace

double least_share(const std::vector<ActiveTerm>& model) {
  double share = kLeastShare;
  for (const ActiveTerm& t : model)
    if (t.added && CandidateBank::has_shape(t.term))
      share = std::max(share, CandidateBank::friction_shape(t.term.kind) ? kLeastBesideFriction : kLeastBesideShape);
  return share;
}

SearchResult search(Rows& rows, const CandidateBank& bank) {
  Moves moves(rows, bank);
  SearchResult result;
  State state = moves.settled(base_model(rows), 3);
  result.base = state.model;
  result.base_fit = state.fit;
  const double start = state.fit.chi2;
  double first_gain = 0, share = kLeastShare;
  while (added_terms(state.model).size() < kMostTerms) {
    const double least_gain = share * first_gain;
    if (!moves.extend(state, least_gain, 4) && !moves.extend_beside_reversals(state, least_gain)) break;
    moves.settle_friction_shapes(state);
    first_gain = std::max(first_gain, start - state.fit.chi2);
    share = std::max(share, least_share(state.model));
    for (int i = 0; added_terms(state.model).size() > 1 && i < 3 && moves.swap(state); ++i) {
    }
  }
  while (added_terms(state.model).size() > 1 && moves.merge(state)) {
  }
  moves.settle_friction_shapes(state);
  while (!review(rows, bank, state, result)) {
  }
  result.model = state.model;
  result.fit = state.fit;
  return result;
}

}  // namespace diagnosis
