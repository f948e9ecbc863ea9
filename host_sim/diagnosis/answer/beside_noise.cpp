#include "beside_noise.hpp"

#include <algorithm>
#include <cmath>

#include "../choice/most_noise.hpp"
#include "answer.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kMuchOff = 0.05;  // of a number: less nobody would act on

// Little of what a record tells, where it tells a number no better: a force that is missing may have gone into it.
bool any_uncertain(const State& fitted) {
  const std::vector<Determined> found = determined(fitted.fit, fitted.model);
  const std::vector<Parameter> numbers = parameters_of(fitted.model);
  for (size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i].shape == 0 && 1.96 * found[i].std > kMuchOff * std::abs(fitted.model[numbers[i].term].value))
      return true;
  return false;
}

}  // namespace

std::vector<Attempt> near_chance(const Task& task, const State& beside, const Left& left) {
  std::vector<Attempt> tried;
  if (!beside.fit.ok || beside.unseen.empty()) return tried;
  if (left.worst() <= kSurelyNoise && !any_uncertain(beside)) return tried;
  const std::vector<Candidate> candidates = candidates_beside(task.system, beside.model, task.records, false);
  Screen seen = screen(task.system, task.records, beside.model, beside.seen, beside.fit, candidates, 0);
  std::sort(seen.singles.begin(), seen.singles.end(), [](const Screened& a, const Screened& b) { return a.z > b.z; });
  for (const Screened& one : seen.singles) {
    if (!(one.z > kByChance) || tried.size() == kShortList) break;
    const Candidate& c = candidates[one.candidate];
    if (c.host >= 0) continue;  // a shape of the rig's own force: accelerometers round its jumps alike
    Attempt a = attempt(task, beside, {c}, {std::vector<double>(c.terms.size(), 0.0)}, kTrialSteps);
    if (!(a.error < 1)) a = attempt(task, beside, {c}, {one.value}, kTrialSteps, From::kMeasured);  // stuck on the way
    if (a.state.fit.ok && !a.rounds && a.z > kByChance && unseen_agrees(a)) tried.push_back(a);
  }
  return tried;
}

bool worth_a_search(const std::vector<Attempt>& tried) {
  return std::any_of(tried.begin(), tried.end(),
                     [](const Attempt& a) { return a.z > kSure && a.unseen_deviations > kByChance; });
}

void doubt_numbers(const Task& task, const std::vector<Attempt>& tried, Diagnosis& d) {
  for (const Attempt& a : tried) {
    PossibleCause possible{
        named_place(task, a.candidates[0].terms[0]), std::clamp(100 * (1 - a.error), 0.0, 100.0), {}};
    for (const diagnosis::Parameter& beside : numbers_of(task, a.state))
      for (diagnosis::Parameter& p : d.baseline.parameters) {
        const double by = std::abs(beside.value - p.value);
        if (p.name != beside.name || !(p.std > 0) || by <= 1.96 * p.std || by <= kMuchOff * std::abs(p.value)) continue;
        p.may_be_bent = true;
        possible.bends.push_back(beside);
      }
    if (!possible.bends.empty()) d.possible.push_back(possible);
  }
  d.extended.parameters = d.baseline.parameters;
}

}  // namespace diagnosis::runs
