#include "scale.hpp"

#include <algorithm>
#include <cstdio>

#include "../first_values/start.hpp"
#include "between_rivals.hpp"
#include "numbers_of.hpp"

namespace diagnosis::runs {
namespace {

// One that sets the scale, and the cause that says that it is wrong.
struct Setter {
  NamedPlace error;
  double given = 0;  // of a number; 0: a force
};

// Masses, springs and forces; anything else that the rig file knows makes them more than can stand for one another.
std::vector<Setter> setters_of(const Task& task) {
  std::vector<Setter> list;
  for (const ModelTerm& t : rig_as_given(task.system, task.records)) {
    if (!t.known) continue;
    const bool mass = t.term.kind == Kind::kMass;
    if (!mass && t.term.kind != Kind::kStiffness) return {};
    const Term error = mass ? on_dof(Kind::kMassError, t.term.dof) : on_link(Kind::kStiffnessError, t.term.link);
    list.push_back({named_place(task, error), t.value});
  }
  for (size_t dof = 0; dof < task.records[0].force.size(); ++dof)
    if (task.records[0].force[dof].size() > 0)
      list.push_back({named_place(task, on_dof(Kind::kForceGain, static_cast<int>(dof)))});
  return list;
}

}  // namespace

void say_scale(const Task& task, Diagnosis& d) {
  const std::vector<Setter> setters = setters_of(task);
  if (setters.size() != 2 || d.causes.size() != 1) return;
  const Cause& cause = d.causes[0];
  const auto is_named = [&](const Setter& s) { return cause.effect == s.error.effect && cause.where == s.error.where; };
  const auto own = std::find_if(setters.begin(), setters.end(), is_named);
  if (own == setters.end() || cause.parameters.empty()) return;
  list_equal(setters[own == setters.begin() ? 1 : 0].error, d);
  d.verdict = Verdict::kAmbiguous;
  // a number by which it is off, or a force's gain, is all that the others would be off by, the other way round
  const double off = cause.parameters[0].value, wrong = own->given != 0 ? 1 + off / own->given : 1 + off;
  const double factor = own->given != 0 ? 1 / wrong : wrong;
  mark_scaled(task, factor, d);
  char text[200];
  std::snprintf(
      text, sizeof text,
      "nothing but these two sets the scale: measure one of them by itself; if it is the other, every unknown "
      "number is %.4g times as large",
      factor);
  d.advice.push_back(text);
}

}  // namespace diagnosis::runs
