#include "possible_causes.hpp"

#include <algorithm>
#include <cmath>

#include "../numbers/numbers_of.hpp"
#include "answer.hpp"

namespace diagnosis::runs {
namespace {

PossibleCause possible_of(const Task& task, const Nearly& n) {
  return {named_place(task, n.candidate.terms[0]), std::clamp(100 * n.share, 0.0, 100.0), {}};
}

}  // namespace

void say_possible(const Task& task, const Choice& choice, Diagnosis& d) {
  if (!d.causes.empty() || !choice.named.empty() || !beyond_noise(choice.base_left)) return;
  for (const Nearly& n : choice.nearly) {
    PossibleCause possible = possible_of(task, n);
    const std::vector<diagnosis::Parameter> beside = values_of(task, n.model);
    for (diagnosis::Parameter& p : d.baseline.parameters) {
      const auto other = std::find_if(beside.begin(), beside.end(), [&](const auto& o) { return o.name == p.name; });
      if (other == beside.end() || !(p.std > 0) || std::abs(other->value - p.value) <= kHalfOf95 * p.std) continue;
      p.may_be_bent = true;
      possible.bends.push_back(*other);
    }
    d.possible.push_back(possible);
  }
  if (d.possible.empty() && d.verdict == Verdict::kUnknown && choice.nearest)
    d.possible.push_back(possible_of(task, *choice.nearest));
  d.extended.parameters = d.baseline.parameters;
}

}  // namespace diagnosis::runs
