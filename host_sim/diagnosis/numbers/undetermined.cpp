#include "undetermined.hpp"

#include <algorithm>
#include <cmath>

#include "../motion/link_motion.hpp"
#include "parameter_status.hpp"

namespace diagnosis::runs {
namespace {

// Its work is in no parameter.
bool given(const rig_file::Coefficient& coefficient) { return !coefficient.estimate && coefficient.value != 0; }

bool reaches_beyond(const diagnosis::Parameter& p, double per_unit, double all) {
  return kHalfOf95 * p.std * per_unit > all;
}

void mark(const Task& task, std::vector<diagnosis::Parameter>& list) {
  const auto is = [](const diagnosis::Parameter& p, const char* word) { return p.name.rfind(word, 0) == 0; };
  for (diagnosis::Parameter& p : list)
    if (p.std > 0 && (is(p, "mass[") || is(p, "stiffness[") || is(p, "gravity_torque[")))
      p.undetermined = p.undetermined || reaches_beyond(p, 1, std::abs(p.value));
  for (size_t l = 0; l < task.system.known_links; ++l) {
    const rig_file::Link& link = task.system.links[l];
    const std::string label = "[" + rig_file::link_label(link) + "]";
    if (given(link.viscous_N_s_m) || given(link.coulomb_N)) continue;
    const UnitWork work = unit_work_of(link, task.records);
    const auto work_per_unit = [&](const std::string& name) {
      return name == "viscous" + label ? work.viscous : name == "coulomb" + label ? work.coulomb : 0.0;
    };
    for (int pass = 0; pass < 2; ++pass) {  // what is undetermined itself is no measure for another
      double all = 0;
      for (const diagnosis::Parameter& p : list) all += p.undetermined ? 0 : std::abs(p.value) * work_per_unit(p.name);
      for (diagnosis::Parameter& p : list)
        if (p.std > 0 && work_per_unit(p.name) > 0)
          p.undetermined = p.undetermined || reaches_beyond(p, work_per_unit(p.name), all);
    }
  }
}

bool dissipates(const std::string& name) {
  for (const char* word : {"viscous", "coulomb", "damping", "stribeck"})
    if (name.find(word) != std::string::npos) return true;
  return false;
}

// A damper that differs between the directions by more than itself drives the rig in one of them.
bool drives_one_way(const diagnosis::Parameter& p, const std::vector<diagnosis::Parameter>& list) {
  constexpr const char* kAsymmetric = "asymmetric_viscous[";
  if (p.name.rfind(kAsymmetric, 0) != 0) return false;
  const std::string own = "viscous" + p.name.substr(p.name.find('['));
  const auto damper = std::find_if(list.begin(), list.end(), [&](const auto& o) { return o.name == own; });
  return damper != list.end() && std::abs(p.value) - damper->value > kHalfOf95 * std::hypot(p.std, damper->std);
}

// What dissipates beside an impossible number that does, on its link, shares what bends that.
void mark_company(std::vector<diagnosis::Parameter>& list) {
  const auto place = [](const std::string& name) {
    return (dissipates(name) ? "" : "-") + name.substr(name.find('['));
  };
  for (const diagnosis::Parameter& wrong : list) {
    if (wrong.undetermined || !(impossible(wrong) || drives_one_way(wrong, list))) continue;
    for (diagnosis::Parameter& p : list)
      p.may_be_bent = p.may_be_bent || (p.std > 0 && place(p.name) == place(wrong.name));
  }
}

}  // namespace

void mark_undetermined(const Task& task, Diagnosis& d) {
  for (std::vector<diagnosis::Parameter>* list : {&d.baseline.parameters, &d.extended.parameters})
    mark(task, *list), mark_company(*list);
  std::string names, below;
  const std::vector<diagnosis::Parameter>& told = d.causes.empty() ? d.baseline.parameters : d.extended.parameters;
  for (const diagnosis::Parameter& p : told)
    if (p.undetermined)
      names += (names.empty() ? "" : ", ") + p.name;
    else if (impossible(p))
      below += (below.empty() ? "" : ", ") + p.name;
  if (!below.empty())
    d.advice.push_back(
        below +
        " below nought cannot be: something that is missing, or a motion too quiet for its noise, has gone "
        "into it; fit without it, and look whether unseen data are followed as well");
  if (!names.empty())
    d.advice.push_back("these records do not tell " + names +
                       ": record more of the motion (a decay from its start, several of them, or a driven record)");
}

}  // namespace diagnosis::runs
