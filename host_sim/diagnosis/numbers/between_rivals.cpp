#include "between_rivals.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "../choice/round.hpp"
#include "../first_values/start.hpp"
#include "../terms/naming.hpp"
#include "../trial/attempt.hpp"
#include "host_sim/vocabulary/said.hpp"
#include "numbers_of.hpp"

namespace diagnosis::runs {
namespace {

// Marks it where that is beyond its interval.
bool bent(diagnosis::Parameter& p, double by) {
  const bool beyond = p.std > 0 && std::abs(by) > kHalfOf95 * p.std;
  p.may_be_bent = p.may_be_bent || beyond;
  return beyond;
}

// What a number is beside each of the rivals that take it out of its interval.
struct Elsewhere {
  double value = 0;
  std::string rival;
};
using ElsewhereByName = std::map<std::string, std::vector<Elsewhere>>;

void mark(const Task& task, const Rival& r, Diagnosis& d, ElsewhereByName& elsewhere) {
  const NamedPlace place = named_place(task, r.candidate.terms[0]);
  const std::string rival = vocabulary::said(place.effect, place.where);
  for (const Move& m : r.moves)
    for (diagnosis::Parameter& p : d.extended.parameters)
      if (p.name == m.name && bent(p, m.by)) elsewhere[p.name].push_back({p.value + m.by, rival});
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

// One line a number, however many rivals there are: the two that take it farthest.
void tell(const ElsewhereByName& elsewhere, Diagnosis& d) {
  for (const diagnosis::Parameter& p : d.extended.parameters) {
    const auto found = elsewhere.find(p.name);
    if (found == elsewhere.end()) continue;
    const auto less = [](const Elsewhere& a, const Elsewhere& b) { return a.value < b.value; };
    const auto [low, high] = std::minmax_element(found->second.begin(), found->second.end(), less);
    std::string text = p.name + " is " + number(p.value) + " with the cause named, " + number(low->value) + " with " +
                       low->rival + " in its place";
    if (low != high) text += ", " + number(high->value) + " with " + high->rival;
    d.advice.push_back(text);
  }
}

}  // namespace

void mark_rows_rivals(const Task& task, const Choice& fitted, const State& with_it, Diagnosis& d) {
  const State& base = fitted.base;
  if (d.ambiguous_with.empty() || !with_it.fit.ok) return;
  const double noise = noise_share(fitted.base_left, base.fit);
  ElsewhereByName elsewhere;
  const std::vector<Candidate> all = candidates_beside(task.system, base.model, task.records, false);
  for (const Screened& one : screen(task.system, task.records, base.model, base.seen, base.fit, all, 0).singles) {
    const Candidate& c = all[one.candidate];
    const NamedPlace place = named_place(task, c.terms[0]);
    if (std::find(d.ambiguous_with.begin(), d.ambiguous_with.end(), place) == d.ambiguous_with.end()) continue;
    const State rival = attempt(task, base, all, one, noise).state;
    if (!rival.fit.ok) continue;
    mark(task, {c, error_over(rival.fit, with_it.fit), moves_between(task, base.model, with_it.model, rival.model)}, d,
         elsewhere);
  }
  tell(elsewhere, d);
}

void mark_between_rivals(const Task& task, const Choice& choice, Diagnosis& d) {
  ElsewhereByName elsewhere;
  for (const Named& named : choice.named)
    for (const Rival& r : named.rivals) mark(task, r, d, elsewhere);
  tell(elsewhere, d);
}

void mark_replaceable(Diagnosis& d) {
  const bool known = std::any_of(d.causes.begin(), d.causes.end(), [](const Cause& c) { return !c.rivals.empty(); });
  for (const Cause& c : d.causes) {
    if (d.ambiguous_with.empty() || (known && c.rivals.empty())) continue;
    for (const diagnosis::Parameter& own : c.parameters)
      for (diagnosis::Parameter& p : d.extended.parameters) p.may_be_bent = p.may_be_bent || p.name == own.name;
  }
}

void mark_scaled(const Task& task, double factor, Diagnosis& d) {
  for (const ModelTerm& t : rig_as_given(task.system, task.records))
    for (diagnosis::Parameter& p : d.extended.parameters)
      if (!t.known && p.name == parameter_name(task.system, t.term)) bent(p, (factor - 1) * p.value);
}

}  // namespace diagnosis::runs
