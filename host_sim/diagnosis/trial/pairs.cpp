#include "pairs.hpp"

#include <algorithm>

#include "merit.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kPairTrials = 8, kPairTrialsInNoise = 2;
constexpr double kPairRows = 4e4;   // samples that a search among pairs may simulate
constexpr double kAsPromising = 4;  // of what a pair leaves, as the linearisation has it

// Pairs that promise about as much as the best of them; the simpler ones first.
std::vector<ScreenedPair> promising_pairs(const Beside& b) {
  std::vector<ScreenedPair> list;
  for (const ScreenedPair& p : b.screen.pairs)
    if (1 - p.gain <= kAsPromising * (1 - b.screen.pairs[0].gain) && !hopeless(p.gain, 2, b.noise)) list.push_back(p);
  const auto complexity = [&](const ScreenedPair& p) { return b.all[p.first].complexity + b.all[p.second].complexity; };
  std::stable_sort(list.begin(), list.end(),
                   [&](const ScreenedPair& x, const ScreenedPair& y) { return complexity(x) < complexity(y); });
  return list;
}

// What a single with its best partner promises.
double gain_with_best(const Beside& b, const Attempt* single) {
  double most = 0;
  for (const ScreenedPair& p : b.screen.pairs)
    for (const size_t c : {p.first, p.second})
      if (single && b.all[c].same_place(single->candidates[0])) most = std::max(most, p.gain);
  return most;
}

size_t most_pairs(const Beside& b) {
  if (b.noise >= kMostlyNoise) return kPairTrialsInNoise;
  double rows = 0;
  for (const Window& w : b.now.seen) rows += static_cast<double>(w.length);
  return static_cast<size_t>(std::clamp(kPairRows / rows, 2.0, static_cast<double>(kPairTrials)));
}

}  // namespace

std::vector<Attempt> tried_pairs(const Beside& b, const Attempt* single) {
  const double with_best = gain_with_best(b, single);
  const size_t most = most_pairs(b);
  std::vector<std::vector<Candidate>> list;
  for (const ScreenedPair& p : promising_pairs(b)) {
    if (list.size() >= most) break;
    if (single && 1 - p.gain > 0.5 * (1 - with_best)) break;
    const std::vector<Candidate> both = {b.all[p.first], b.all[p.second]};
    const auto same = [&](const std::vector<Candidate>& other) {
      return (other[0].same_place(both[0]) && other[1].same_place(both[1])) ||
             (other[0].same_place(both[1]) && other[1].same_place(both[0]));
    };
    if (std::none_of(list.begin(), list.end(), same)) list.push_back(both);
  }
  return side_by_side(list.size(), [&](size_t i) {
    return attempt(b.task, b.now, list[i], {{0.0}, {0.0}}, 2 * kTrialSteps);
  });
}

}  // namespace diagnosis::runs
