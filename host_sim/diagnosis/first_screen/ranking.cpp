#include "ranking.hpp"

#include "../terms/naming.hpp"

namespace diagnosis {

std::vector<RankedCandidate> ranking(const System& system, const Rows& rows, const CandidateBank& bank,
                                     const SearchResult& found, size_t count) {
  std::vector<ActiveTerm> model = found.base;
  const Fit fit = fit_model(rows, model);  // the rows' noise is that of the final model
  std::vector<RankedCandidate> list;
  for (const Found& f : ranked(rows, bank, model, fit, 5)) {
    if (list.size() == count) break;
    const Term& term = f.candidate.term();
    list.push_back(
        {word_of(term.kind), place_of(system, term, rows.records()[0]), f.score, f.candidate.needed(f.gain.std)});
  }
  return list;
}

}  // namespace diagnosis
