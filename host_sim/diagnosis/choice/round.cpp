#include "round.hpp"

#include <algorithm>
#include <cmath>

#include "../doubts/possible.hpp"
#include "../trial/attempt.hpp"
#include "../trial/bristles.hpp"
#include "../trial/merit.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kPlainGain = 0.1;  // of the squared error: worth a fit though it shows in one burst alone
constexpr size_t kPairs = 40, kPairTrials = 8, kPairTrialsInNoise = 2;
constexpr double kPairRows = 4e4;   // samples that a search among pairs may simulate
constexpr double kAsPromising = 4;  // of what a pair leaves, as the linearisation has it

// Whether a simpler cause leaves no more than what each of its fewer numbers is worth.
bool as_good(const Attempt& simpler, const Attempt& best, double worth) {
  return whole_error(simpler) < whole_error(best) * std::pow(worth, best.complexity - simpler.complexity);
}

bool by_whole_error(const Attempt& a, const Attempt& b) { return whole_error(a) < whole_error(b); }

constexpr double kMoreThanNoise = 2;  // times the noise's share: so much left tells of a shape in a wrong valley too

// A shape's error has valleys. Where the best single leaves more than noise it is fitted from its other shapes as well.
Attempt reshaped(const Task& task, const State& now, const std::vector<Candidate>& all, const Attempt& best,
                 double noise) {
  Attempt found = best;
  if (best.candidates.size() > 1 || best.rounds || !best.state.fit.ok || whole_error(best) < kMoreThanNoise * noise)
    return found;
  for (const Candidate& c : all) {
    if (!c.same_place(best.candidates[0]) || c.terms.size() > 1 || c.terms[0].kind == Kind::kResonance) continue;
    const Attempt other = attempt(task, now, {c}, {{0.0}}, kTrialSteps);
    if (other.state.fit.ok && !other.rounds && by_whole_error(other, found)) found = other;
  }
  return found;
}

// An effect that leaves less of what the fit has seen and of what it has not, by as much as a cause has to.
void keep_nearest(const Task& task, const State& now, const std::vector<Attempt>& tried, double noise, Choice& choice) {
  for (const Attempt& t : tried) {
    if (!t.state.fit.ok || t.rounds || std::max(t.error, t.unseen) > 1 - kShare) continue;
    if (cannot_be(task, now, t) || may_be_nought(t.state, now.model.size())) continue;
    const Nearly found{t.candidates[0], t.state.model, share_of(t, noise)};
    if (!choice.nearest || found.share > choice.nearest->share) choice.nearest = found;
  }
}

}  // namespace

Round round_of(const Task& task, const State& now, size_t already, const Left& left, double noise, double worth,
               Choice& choice) {
  Round round;
  choice.last_candidates = candidates_beside(task.system, now.model, task.records, left.worst() > kPlainlyLeft);
  choice.last_screen = screen(task.system, task.records, now.model, now.seen, now.fit, choice.last_candidates, kPairs);
  const Screen& s = choice.last_screen;
  std::vector<Attempt> singles;
  bool dry_tried = false;  // where it holds the motion its linearisation tells little of what it brings
  for (const Screened& one : s.singles) {
    const bool dry = choice.last_candidates[one.candidate].terms[0].kind == Kind::kMissingCoulomb;
    if (singles.size() >= kShortList && !(dry && !dry_tried)) continue;
    const double least = (noise < kMostlyNoise ? kByChance : kSure) * std::sqrt(static_cast<double>(already + 1));
    if (one.z < least && one.gain < kPlainGain) continue;
    dry_tried = dry_tried || dry;
    singles.push_back(attempt(task, now, choice.last_candidates, one, noise));
  }
  std::sort(singles.begin(), singles.end(), by_whole_error);
  if (!singles.empty()) singles[0] = reshaped(task, now, choice.last_candidates, singles[0], noise);
  if (!singles.empty() && is_bristles(singles[0])) {
    const Attempt dry = without_bristles(task, now, singles[0]);
    if (dry.state.fit.ok && !clearly_better(singles[0], dry, noise)) {
      if (!dry.candidates.empty())
        singles.insert(singles.begin(), dry);
      else if (whole_error(dry) < kPays)
        round.stuck = true, round.unstuck = dry.state;
      else
        singles.erase(singles.begin());  // the rig's own friction follows as well, and brings nothing: nor do they
    }
  }
  if (round.stuck) return round;
  choice.nearly.clear();
  for (const Attempt& t : singles)
    if (nearly(t)) choice.nearly.push_back({t.candidates[0], t.state.model, share_of(t, noise)});
  if (already == 0) keep_nearest(task, now, singles, noise, choice);
  const State beside = rounded(task, now, singles);
  // Where filters round the jumps of friction, damping laws that change with the rate look like that: they have to be there
  // beside it too.
  const auto stands = [&](const Attempt& t) {
    if (!passes(t, already, noise)) return false;
    if (!beside.fit.ok || whole_error(t) < error_over(beside.fit, now.fit)) return true;
    const std::vector<std::vector<double>> start(t.candidates.size(), {0.0});
    const double left_noise = std::min(1.0, noise / error_over(beside.fit, now.fit));
    return passes(attempt(task, beside, t.candidates, start, kTrialSteps), already, left_noise);
  };
  // what does the work of a number of the rig, puts energy in, or may be nought, comes behind what does not
  const auto beside_all = [&](const Attempt& t) {
    return stands(t) && !cannot_be(task, now, t) && !may_be_nought(t.state, now.model.size());
  };
  auto first = std::find_if(singles.begin(), singles.end(), beside_all);
  if (first == singles.end()) first = std::find_if(singles.begin(), singles.end(), stands);
  if (first != singles.end()) {
    round.best = *first, round.found = true;
    for (auto t = first + 1; t < singles.end(); ++t)  // the other is its rival
      if (t->complexity < round.best.complexity && as_good(*t, *first, worth) && stands(*t)) round.best = *t;
    for (const Attempt& t : singles) {
      if (!t.state.fit.ok || t.rounds || t.candidates[0].same_place(round.best.candidates[0])) continue;
      if (whole_error(t) > worth * whole_error(round.best)) continue;
      round.passed_over.push_back(t.candidates[0]);
      keep_shape(t.state.model, round.passed_over.back());
    }
  }
  // two that help only together: where no single does, or where they leave half of what the best single with its best
  // partner does
  double with_best = 0;
  for (const ScreenedPair& p : s.pairs)
    for (size_t c : {p.first, p.second})
      if (round.found && choice.last_candidates[c].same_place(round.best.candidates[0]))
        with_best = std::max(with_best, p.gain);
  std::vector<Attempt> pairs;
  double rows = 0;
  for (const Window& w : now.seen) rows += static_cast<double>(w.length);
  const size_t most = noise < kMostlyNoise
                          ? static_cast<size_t>(std::clamp(kPairRows / rows, 2.0, static_cast<double>(kPairTrials)))
                          : kPairTrialsInNoise;
  // of those that promise as much the simpler ones come first
  std::vector<ScreenedPair> promising;
  for (const ScreenedPair& p : s.pairs)
    if (1 - p.gain <= kAsPromising * (1 - s.pairs[0].gain) && !hopeless(p.gain, 2, noise)) promising.push_back(p);
  const auto complexity = [&](const ScreenedPair& p) {
    return choice.last_candidates[p.first].complexity + choice.last_candidates[p.second].complexity;
  };
  std::stable_sort(promising.begin(), promising.end(),
                   [&](const ScreenedPair& x, const ScreenedPair& y) { return complexity(x) < complexity(y); });
  for (const ScreenedPair& p : promising) {
    if (pairs.size() >= most) break;
    if (round.found && 1 - p.gain > 0.5 * (1 - with_best)) break;
    const std::vector<Candidate> both = {choice.last_candidates[p.first], choice.last_candidates[p.second]};
    const auto same = [&](const Attempt& t) {
      return (t.candidates[0].same_place(both[0]) && t.candidates[1].same_place(both[1])) ||
             (t.candidates[0].same_place(both[1]) && t.candidates[1].same_place(both[0]));
    };
    if (std::any_of(pairs.begin(), pairs.end(), same)) continue;
    pairs.push_back(attempt(task, now, both, {{0.0}, {0.0}}, 2 * kTrialSteps));
  }
  const Attempt* best = nullptr;
  for (const Attempt& t : pairs) {
    if (!stands(t)) continue;
    const bool better = best && (t.complexity == best->complexity ? whole_error(t) < whole_error(*best)
                                                                  : clearly_better(t, *best, noise));
    if (!best || better) best = &t;
  }
  if (best && (!round.found || whole_error(*best) < 0.5 * whole_error(round.best)))
    round.best = *best, round.found = true, round.passed_over.clear();
  return round;
}

}  // namespace diagnosis::runs
