#include "warming.hpp"

#include <algorithm>
#include <cmath>

#include "../trial/merit.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kFewestRecords = 3;  // with two a coefficient that follows the level looks the same

// The candidates whose coefficients chance does not give.
std::vector<Candidate> that_drift(const Attempt& a, size_t own_terms) {
  std::vector<Candidate> list;
  const std::vector<Determined> found = determined(a.state.fit, a.state.model);
  const std::vector<Parameter> parameters = parameters_of(a.state.model);
  for (size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].term >= own_terms && std::abs(found[i].z) > kNamed)
      list.push_back(a.candidates[parameters[i].term - own_terms]);
  return list;
}

}  // namespace

Attempt warming(const Task& task, const State& beside, double noise) {
  std::vector<Candidate> list;
  if (task.training >= kFewestRecords)
    for (const ModelTerm& t : beside.model)
      if (t.term.kind == Kind::kViscous) {
        Candidate c;
        c.terms = {on_link(Kind::kDriftingViscous, t.term.link, kAcrossRecords)}, c.complexity = 1;
        list.push_back(c);
      }
  while (!list.empty()) {
    const std::vector<std::vector<double>> start(list.size(), {0.0});
    const Attempt a = attempt(task, beside, list, start, kTrialSteps);
    if (!a.state.fit.ok || !unseen_agrees(a) || a.unseen > kPays || share_of(a, noise) < kShare) break;
    const std::vector<Candidate> drifting = that_drift(a, beside.model.size());
    if (drifting.size() == list.size()) return a;
    list = drifting;
  }
  return {};
}

}  // namespace diagnosis::runs
