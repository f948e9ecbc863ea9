// Candidates in the order of what they would bring, the best shape of each kind and place, and the best two by two.
#include <algorithm>
#include <cmath>

#include "pair_gains.hpp"

namespace diagnosis::runs {
namespace {

constexpr std::ptrdiff_t kShapes = 2;  // of a kind and place, the best: they are paired with others

std::vector<Term> terms_of(const std::vector<Candidate>& candidates) {
  std::vector<Term> terms;
  for (const Candidate& c : candidates) terms.insert(terms.end(), c.terms.begin(), c.terms.end());
  return terms;
}

std::vector<Screened> ranked(const std::vector<Candidate>& candidates, const Gains& gains) {
  std::vector<Screened> all;
  Index column = 0;
  for (size_t c = 0; c < candidates.size(); ++c) {
    const Index own = column;
    column += static_cast<Index>(candidates[c].terms.size());
    const Gain gain = candidates[c].terms.size() == 2 ? gains.of_two(own) : gains.of_column(own);
    if (gain.value.empty() || !std::isfinite(gain.share)) continue;
    all.push_back({c, gain.share, gain.z, gain.value, gains.moves(own, gain.value)});
  }
  std::sort(all.begin(), all.end(), [](const Screened& a, const Screened& b) { return a.gain > b.gain; });
  return all;
}

std::vector<Screened> best_of_places(const std::vector<Screened>& all, const std::vector<Candidate>& candidates) {
  std::vector<Screened> best;
  for (const Screened& s : all) {
    const Candidate& own = candidates[s.candidate];
    if (!own.allows(s.value[0])) continue;
    const bool seen = std::any_of(best.begin(), best.end(),
                                  [&](const Screened& o) { return candidates[o.candidate].same_place(own); });
    if (!seen) best.push_back(s);
  }
  return best;
}

std::vector<size_t> chosen_for_pairs(const std::vector<Screened>& all, const std::vector<Candidate>& candidates,
                                     size_t most) {
  std::vector<size_t> chosen;
  for (const Screened& s : all) {
    if (chosen.size() >= most) break;
    const Candidate& own = candidates[s.candidate];
    if (own.terms.size() > 1) continue;
    const auto same =
        std::count_if(chosen.begin(), chosen.end(), [&](size_t o) { return candidates[o].same_place(own); });
    if (same < kShapes) chosen.push_back(s.candidate);
  }
  return chosen;
}

}  // namespace

Screen screen(const System& system, const std::vector<Prepared>& records, const Model& model,
              const std::vector<Window>& windows, const Fitted& fit, const std::vector<Candidate>& candidates,
              size_t pairs) {
  Screen out;
  const auto sums = sums_by_block(system, records, model, windows, fit, terms_of(candidates));
  if (!sums) return out;
  const Gains gains(*sums);
  const std::vector<Screened> all = ranked(candidates, gains);
  out.singles = best_of_places(all, candidates);
  const std::vector<size_t> chosen = chosen_for_pairs(all, candidates, pairs);
  if (chosen.size() < 2) return out;
  out.pairs = pair_gains(system, records, model, windows, fit, candidates, chosen, gains, sums->residual_square);
  return out;
}

}  // namespace diagnosis::runs
