#include "sharpened_search.hpp"

#include "sharpen.hpp"

namespace diagnosis {
namespace {

constexpr double kWorthSharpening = 1.2;  // chi-squared per degree of freedom
constexpr int kSlowRounds = 6;
constexpr double kAsGood = 1.01;  // chi-squared of a hold over that of a fault

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

SearchResult search_sharpening(std::unique_ptr<Bench>& owner) {
  SearchResult found = search(*owner->rows, *owner->bank);
  const int rounds = found.base_fit.ratio() <= kWorthSharpening ? 0 : owner->rows->absolute() ? 1 : kSlowRounds;
  for (int i = 0; i < rounds && !found.added.empty(); ++i) {
    auto sharper = std::make_unique<Bench>(Bench{owner->system, owner->records, nullptr, nullptr, owner->holds});
    sharpen(sharper->records, owner->system, found.model);
    sharper->lay_out();
    const SearchResult again = search(*sharper->rows, *sharper->bank);
    if (again.fit.ratio() >= found.fit.ratio()) break;
    found = again, owner = std::move(sharper);
    if (found.fit.ratio() < kWorthSharpening) break;
  }
  return found;
}

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
    const std::vector<KnownHold> holds{{hold, static_cast<size_t>(dof), 1 / mass}};
    auto trial = std::make_unique<Bench>(Bench{owner->system, held(smooth, holds), nullptr, nullptr, holds});
    sharpen_all(trial->system, trial->records);
    trial->lay_out();
    const SearchResult again = search_sharpening(trial);
    if (again.added.size() >= terms || again.fit.ratio() >= least) continue;
    least = again.fit.ratio(), found = again, owner = std::move(trial);
  }
}

}  // namespace diagnosis
