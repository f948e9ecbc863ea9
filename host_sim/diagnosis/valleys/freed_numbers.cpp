#include "freed_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "../residual/motion_error.hpp"
#include "../trial/settle.hpp"

namespace diagnosis::runs {
namespace {

// Of a number: nobody would call it a tolerance, and no sensor's fault or other effect looks so.
constexpr double kMuch = 0.5;

double softest_spring(const Model& given) {
  double least = 1e300;
  for (const ModelTerm& t : given)
    if (t.term.kind == Kind::kStiffness && t.value != 0) least = std::min(least, std::abs(t.value));
  return least;
}

std::vector<Freed> freed_numbers(const State& s, const Model& given) {
  std::vector<Freed> list;
  const std::vector<runs::Parameter> parameters = parameters_of(s.model);
  const std::vector<Determined> d = determined(s.fit, s.model);
  for (size_t i = 0; i < parameters.size(); ++i) {
    const ModelTerm& g = given[parameters[i].term];
    if (parameters[i].shape || !g.known) continue;
    const bool spring = g.term.kind == Kind::kStiffnessError;
    const double size = spring ? softest_spring(given) : std::abs(g.value);
    list.push_back({parameters[i].term, g.value, s.model[parameters[i].term].value, d[i].std, size});
  }
  return list;
}

}  // namespace

bool Freed::by_much() const { return std::abs(off()) > kMuch * std::abs(given); }

bool Freed::wrong() const { return std::abs(off()) > std::max(kSure * std, kSmall * size); }

bool may_be_wrong(const ModelTerm& t, bool scale) {
  if (t.added) return true;  // what the rig file may lack
  return t.known && t.value != 0 && (t.term.kind == Kind::kStiffness || (scale && t.term.kind == Kind::kMass));
}

Model with_missing_links(const Task& task, Model model) {
  for (size_t l = task.system.known_links; l < task.system.links.size(); ++l) {
    ModelTerm spring, damper;
    spring.term = on_link(Kind::kStiffnessError, static_cast<int>(l));
    damper.term = on_link(Kind::kMissingViscous, static_cast<int>(l));
    for (ModelTerm* t : {&spring, &damper}) t->added = true, model.push_back(*t);
  }
  return model;
}

std::vector<Freed> wrong_numbers(const Task& task, const Model& given, State& s) {
  for (;;) {
    const std::vector<Freed> freed = freed_numbers(s, given);
    bool any_right = false;
    for (const Freed& f : freed)
      if (!f.wrong()) s.model[f.term] = given[f.term], any_right = true;
    if (!any_right) return freed;
    s.fit = fit(task.system, task.records, s.model, s.seen, kBaseSteps);
    if (!s.fit.ok) return {};
  }
}

}  // namespace diagnosis::runs
