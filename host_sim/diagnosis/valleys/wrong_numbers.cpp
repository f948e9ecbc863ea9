#include "wrong_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "../choice/horizon.hpp"
#include "../first_values/start.hpp"
#include "../trial/attempt.hpp"
#include "../trial/merit.hpp"
#include "freed_numbers.hpp"

namespace diagnosis::runs {
namespace {

// What the rig as given does not follow, and over which the freed rig is fitted first.
constexpr double kOnePeriod = 1;
constexpr double kOneFactor = 0.05;  // by which factors may differ that a single wrong unit or gain makes

bool driven_by_force(const Task& task) {
  for (const Prepared& p : task.records)
    for (const Vec& f : p.force)
      if (f.size() > 0 && f.cwiseAbs().maxCoeff() > 0) return true;
  return false;
}

// Followed over one period, then over windows up to the longest.
bool follows_when_freed(const Task& task, double longest, State& s) {
  double periods = std::min(longest, kOnePeriod);
  lay(task, periods, s);
  s.fit = fit(task.system, task.records, s.model, s.seen, kBaseSteps);
  if (!follows(task, s)) return false;
  widen(task, longest, periods, s);
  return true;
}

struct Causes {
  std::vector<Candidate> list;
  std::vector<std::vector<double>> values;
  void add(const Term& term, double value) {
    Candidate c;
    c.terms = {term};
    list.push_back(c), values.push_back({value});
  }
};

// The DOF whose force alone drives the rig; -1: none, or several.
int sole_drive(const Task& task) {
  int dof = -1;
  const std::vector<Vec>& force = task.records[0].force;
  for (size_t i = 0; i < force.size(); ++i)
    if (force[i].size() > 0) dof = dof < 0 ? static_cast<int>(i) : static_cast<int>(force.size());
  return dof < static_cast<int>(force.size()) ? dof : -1;
}

// The reading of a force that is r times the force makes all masses and springs r times as large.
bool by_one_factor(const std::vector<Freed>& wrong, const Model& given, double& factor) {
  const auto can_be = [](const ModelTerm& t) { return may_be_wrong(t, true); };
  if (wrong.size() < 2 || wrong.size() < static_cast<size_t>(std::count_if(given.begin(), given.end(), can_be)))
    return false;
  factor = wrong[0].found / wrong[0].given;
  return std::all_of(wrong.begin(), wrong.end(),
                     [&](const Freed& f) { return std::abs(f.found / f.given / factor - 1) < kOneFactor; });
}

Causes causes_of(const Task& task, const std::vector<Freed>& wrong, const Model& given) {
  Causes causes;
  double factor = 0;
  const int dof = sole_drive(task);
  if (dof >= 0 && by_one_factor(wrong, given, factor)) {
    causes.add(on_dof(Kind::kForceGain, dof), 1 - 1 / factor);
    return causes;
  }
  for (const Freed& f : wrong) {
    const Term& t = given[f.term].term;
    causes.add(t.kind == Kind::kMass        ? on_dof(Kind::kMassError, t.dof)
               : t.kind == Kind::kStiffness ? on_link(Kind::kStiffnessError, t.link)
                                            : t,
               f.off());
  }
  return causes;
}

// The causes beside the rig as given, all at once: from the freed rig's other numbers and from the measured motion, because those
// of the rig as given are as wrong as it is.
bool adopted(const Task& task, const Causes& causes, const Model& freed, Choice& choice) {
  State beside = choice.base;
  for (size_t i = 0; i < beside.model.size(); ++i)
    if (!beside.model[i].known) beside.model[i].value = freed[i].value;
  const Attempt all = attempt(task, beside, causes.list, causes.values, kBaseSteps, From::kMeasured);
  if (!all.state.fit.ok || all.rounds || all.no_sensors || !(all.z > kSure) || !unseen_agrees(all) ||
      !(motion_error(task, all.state) < kFollows))
    return false;
  choice.base_left = left_by(task.system, task.records, choice.base);
  choice.base_fits_nothing = false;
  const double share = share_of(all, noise_share(choice.base_left, choice.base.fit));
  for (const Candidate& c : causes.list) choice.named.push_back(Named{c, all.z, share, {}, true, true});
  choice.final = all.state;
  choice.final_left = left_by(task.system, task.records, choice.final);
  return true;
}

}  // namespace

namespace {

// given: what the rig file says, freed all at once.
Wrong name_wrong(const Task& task, const Model& given, Choice& choice) {
  const bool scale = driven_by_force(task);
  State s;
  s.model = given;
  for (ModelTerm& t : s.model) t.known = t.known && !may_be_wrong(t, scale);
  start_values(task.system, task.records, s.model);
  if (!follows_when_freed(task, longest_horizon(task.records), s)) return Wrong::kNo;
  const std::vector<Freed> wrong = wrong_numbers(task, given, s);
  if (wrong.empty()) return Wrong::kNo;
  Choice with_them = over_windows(task, choice, longest_horizon(task.records));
  if (!with_them.base.fit.ok || with_them.base.unseen.empty() ||
      !adopted(task, causes_of(task, wrong, given), s.model, with_them))
    return Wrong::kNo;
  choice = with_them;
  const bool all_by_much = std::all_of(wrong.begin(), wrong.end(), [](const Freed& f) { return f.by_much(); });
  return all_by_much && !beyond_noise(choice.final_left) ? Wrong::kSurely : Wrong::kPerhaps;
}

constexpr size_t kMostDofs = 6;  // 21 places of a spring

}  // namespace

Wrong name_wrong_numbers(const Task& task, Choice& choice) {
  const bool follows =
      !choice.base_fits_nothing && choice.periods >= std::min(kOnePeriod, longest_horizon(task.records));
  if (follows || !choice.named.empty()) return Wrong::kNo;
  const Model given = rig_as_given(task.system, task.records);
  const Wrong found = name_wrong(task, given, choice);
  return found == Wrong::kNo && task.system.dofs() <= kMostDofs
             ? name_wrong(task, with_missing_links(task, given), choice)
             : found;
}

}  // namespace diagnosis::runs
