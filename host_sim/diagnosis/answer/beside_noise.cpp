#include "beside_noise.hpp"

#include <algorithm>
#include <cmath>

#include "../choice/round.hpp"
#include "../numbers/numbers_of.hpp"
#include "../residual/most_noise.hpp"
#include "../trial/attempt.hpp"
#include "../trial/merit.hpp"
#include "answer.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kMuchOff = 0.05;  // of a number: less nobody would act on
// Times what the linearisation moves a number by: no fit goes as far. Of laws without a shape it is right to some percent; one whose shape
// is fitted too, from the nearest on a grid, has gone five times as far.
constexpr double kNoFarther = 8;

// Little of what a record tells, where it tells a number no better: a force that is missing may have gone into it.
bool any_uncertain(const State& fitted) {
  const std::vector<Determined> found = determined(fitted.fit, fitted.model);
  const std::vector<Parameter> numbers = parameters_of(fitted.model);
  for (size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i].shape == 0 && kHalfOf95 * found[i].std > kMuchOff * std::abs(fitted.model[numbers[i].term].value))
      return true;
  return false;
}

}  // namespace

std::vector<Attempt> near_chance(const Task& task, const State& beside, const Left& left,
                                 const std::function<bool(const Screened&)>& matters) {
  std::vector<Attempt> tried;
  if (!beside.fit.ok || beside.unseen.empty()) return tried;
  if (left.worst() <= kSurelyNoise && !any_uncertain(beside)) return tried;
  const std::vector<Candidate> candidates = candidates_beside(task.system, beside.model, task.records, false);
  Screen seen = screen(task.system, task.records, beside.model, beside.seen, beside.fit, candidates, 0);
  std::sort(seen.singles.begin(), seen.singles.end(), [](const Screened& a, const Screened& b) { return a.z > b.z; });
  size_t spared = 0;
  for (const Screened& one : seen.singles) {
    if (!(one.z > kByChance) || tried.size() + spared >= kShortList) break;
    const Candidate& c = candidates[one.candidate];
    if (c.host >= 0) continue;  // a shape of the rig's own force: accelerometers round its jumps alike
    if (!matters(one)) {
      ++spared;
      continue;
    }
    Attempt a = attempt(task, beside, {c}, {std::vector<double>(c.terms.size(), 0.0)}, kTrialSteps);
    if (!(a.error < 1)) a = attempt(task, beside, {c}, {one.value}, kTrialSteps, From::kMeasured);  // stuck on the way
    if (a.state.fit.ok && !a.rounds && a.z > kByChance && unseen_agrees(a)) tried.push_back(a);
  }
  return tried;
}

bool worth_a_search(const Task& task, const State& beside, const Left& left) {
  const std::vector<Attempt> tried = near_chance(task, beside, left, [](const Screened&) { return true; });
  return std::any_of(tried.begin(), tried.end(),
                     [](const Attempt& a) { return a.z > kSure && a.unseen_deviations > kByChance; });
}

namespace {

// Whether a number as it is beside something else is out of the interval of the same number of d, by much.
bool is_bent(const diagnosis::Parameter& p, const diagnosis::Parameter& beside) {
  const double by = std::abs(beside.value - p.value);
  return p.name == beside.name && p.std > 0 && by > kHalfOf95 * p.std && by > kMuchOff * std::abs(p.value);
}

bool any_bent(const std::vector<diagnosis::Parameter>& numbers, const std::vector<diagnosis::Parameter>& beside) {
  for (const diagnosis::Parameter& p : numbers)
    for (const diagnosis::Parameter& o : beside)
      if (is_bent(p, o)) return true;
  return false;
}

// Whether a number might be bent beside one that was screened: what cannot bend any need not be fitted.
bool may_bend(const Task& task, const Model& model, const Screened& one, const Diagnosis& d) {
  const std::vector<Parameter> numbers = parameters_of(model);
  for (const double farther : {0.0, kNoFarther}) {
    Model moved = model;
    for (size_t i = 0; i < numbers.size(); ++i)
      if (numbers[i].shape == 0) moved[numbers[i].term].value += farther * one.moves[static_cast<Index>(i)];
    if (any_bent(d.baseline.parameters, values_of(task, moved))) return true;
  }
  return false;
}

}  // namespace

void doubt_numbers(const Task& task, const State& state, const Left& left, Diagnosis& d) {
  const auto matters = [&](const Screened& one) { return may_bend(task, state.model, one, d); };
  for (const Attempt& a : near_chance(task, state, left, matters)) {
    PossibleCause possible{
        named_place(task, a.candidates[0].terms[0]), std::clamp(100 * (1 - a.error), 0.0, 100.0), {}};
    for (const diagnosis::Parameter& beside : numbers_of(task, a.state))
      for (diagnosis::Parameter& p : d.baseline.parameters)
        if (is_bent(p, beside)) p.may_be_bent = true, possible.bends.push_back(beside);
    if (!possible.bends.empty()) d.possible.push_back(possible);
  }
  d.extended.parameters = d.baseline.parameters;
}

}  // namespace diagnosis::runs
