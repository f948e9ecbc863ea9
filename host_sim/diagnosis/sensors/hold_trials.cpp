// A force that may be held between its samples.
#include "../search/sharpened_search.hpp"
#include "trials.hpp"

namespace diagnosis {
namespace {

// The driven DOF whose force is said to be late or off in gain although one channel alone shows it; none: -1.
int doubtful_drive(const Bench& bench, const SearchResult& found) {
  for (const Found& f : found.added) {
    const Term& t = f.candidate.term();
    const bool fault = t.kind == Kind::kForceGain || t.kind == Kind::kForceDelay;
    if (fault && !tells_hold(bench.records[0], static_cast<size_t>(t.dof))) return t.dof;
  }
  return -1;
}

}  // namespace

void try_holds(std::unique_ptr<Bench>& owner, SearchResult& found) {
  const int dof = doubtful_drive(*owner, found);
  double mass = 0;
  for (const ActiveTerm& a : found.model)
    if (a.term.kind == Kind::kMass && a.term.dof == dof) mass += a.value;
  if (dof < 0 || !(mass > 0)) return;
  const std::vector<FusedRecord> smooth = owner->records;
  const size_t terms = found.added.size();
  double least = kAsGood * found.fit.ratio();
  for (Hold hold : {Hold::kLinear, Hold::kSteps}) {
    const Imposed imposed{{{hold, static_cast<size_t>(dof), 1 / mass}}, {}};
    auto trial = std::make_unique<Bench>(Bench{owner->system, imposed_on(smooth, imposed), imposed});
    trial->lay_out_sharpened();
    std::vector<ActiveTerm> base = base_model(*trial->rows);
    if (terms == 1 && settle(*trial->rows, base, 3).ratio() >= least) continue;  // it would need a term again
    const SearchResult again = search_sharpening(trial);
    if (again.added.size() >= terms || again.fit.ratio() >= least) continue;
    least = again.fit.ratio(), found = again, owner = std::move(trial);
  }
}

}  // namespace diagnosis
