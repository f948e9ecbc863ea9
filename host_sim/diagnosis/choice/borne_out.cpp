// Causes that another test found, borne out by free runs.
#include <algorithm>

#include "../first_values/start.hpp"
#include "../trial/attempt.hpp"
#include "../trial/merit.hpp"
#include "../valleys/other_shapes.hpp"
#include "choice.hpp"
#include "free_damping.hpp"

namespace diagnosis::runs {

void adopt(const Task& task, const std::vector<Candidate>& found, const std::vector<std::vector<double>>& values,
           Choice& choice) {
  Attempt t = attempt(task, choice.base, found, values, kBaseSteps);
  if (!t.state.fit.ok || t.rounds) return;
  for (const Candidate& c : found) {
    choice.named.push_back(Named{c, t.z, share_of(t, noise_share(choice.base_left, choice.base.fit)), {}, true});
  }
  choice.final = t.state;
  free_damping(task, choice.final);
}

namespace {

// The rig's own unknown coefficients as they start where these causes are known.
Model started_beside(const Task& task, const State& base, const std::vector<Candidate>& found,
                     const std::vector<std::vector<double>>& values) {
  Model with = base.model;
  for (size_t i = 0; i < found.size(); ++i) with = joined(with, found[i], values[i]);
  for (ModelTerm& t : with) t.known = t.known || t.added;
  start_values(task.system, task.records, with);
  Model own = base.model;
  for (size_t i = 0; i < own.size(); ++i) own[i].value = with[i].value;
  return own;
}

// Causes that another test found, from its numbers. Where the rig as given does not follow its windows, its coefficients and the
// windows' states are those of another motion: from the measured one too.
Attempt attempt_of_found(const Task& task, const State& base, const std::vector<Candidate>& found,
                         const std::vector<std::vector<double>>& values) {
  Attempt carried = attempt(task, base, found, values, kTrialSteps);
  if (const auto other = from_other_shapes(task, base, found, carried.state)) carried = *other;
  if (follows(task, base)) return carried;
  State measured = base;
  measured.model = started_beside(task, base, found, values);
  Attempt afresh = attempt(task, measured, found, values, kTrialSteps, From::kMeasured);
  const bool usable = carried.state.fit.ok && !carried.rounds;
  return afresh.state.fit.ok && (!usable || whole_error(afresh) < whole_error(carried)) ? afresh : carried;
}

}  // namespace

bool borne_out(const Task& task, const State& base, const std::vector<Candidate>& found,
               const std::vector<std::vector<double>>& values, State* fitted) {
  const Attempt all = attempt_of_found(task, base, found, values);
  if (fitted) *fitted = all.state;
  if (!all.state.fit.ok || all.rounds || !(all.z > kByChance) || !unseen_agrees(all) || !matters(base, all))
    return false;
  for (size_t i = 0; found.size() > 1 && i < found.size(); ++i) {
    std::vector<Candidate> fewer = found;
    std::vector<std::vector<double>> start = values;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i)),
        start.erase(start.begin() + static_cast<std::ptrdiff_t>(i));
    if (attempt_of_found(task, base, fewer, start).unseen <= all.unseen) return false;
  }
  return true;
}

}  // namespace diagnosis::runs
