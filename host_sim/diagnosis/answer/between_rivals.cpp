#include "between_rivals.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../choice/attempt.hpp"
#include "../fit/start.hpp"
#include "../terms/naming.hpp"

namespace diagnosis::runs {
namespace {

// Marks it where that is beyond its interval.
bool bent(Diagnosis& d, const std::string& name, double by) {
  bool any = false;
  for (diagnosis::Parameter& p : d.extended.parameters)
    if (p.name == name && p.std > 0 && std::abs(by) > 1.96 * p.std) p.may_be_bent = any = true;
  return any;
}

void tell(Diagnosis& d, const std::string& name, double by, const std::string& rival) {
  const auto own = std::find_if(d.extended.parameters.begin(), d.extended.parameters.end(),
                                [&](const diagnosis::Parameter& p) { return p.name == name; });
  char text[240];
  std::snprintf(text, sizeof text, "%s is %.4g with the cause named, %.4g with %s in its place", name.c_str(),
                own->value, own->value + by, rival.c_str());
  d.advice.push_back(text);
}

std::string words(const NamedPlace& p) {
  std::string effect = p.effect;
  std::replace(effect.begin(), effect.end(), '_', ' ');
  return effect + " on " + p.where;
}

}  // namespace

void mark_between_rivals(const Task& task, const Choice& choice, Diagnosis& d) {
  for (const Named& named : choice.named)
    for (const Rival& r : named.rivals) {
      if (r.error > kWorth) continue;  // listed to be on the safe side, and no equal
      const NamedPlace place{word_of(r.candidate.terms[0].kind), place_of(task.system, r.candidate.terms[0], {})};
      for (const Move& m : r.moves) {
        const std::string name = parameter_name(task.system, m.term);
        if (bent(d, name, m.by)) tell(d, name, m.by, words(place));
      }
    }
}

void mark_scaled(const Task& task, double factor, Diagnosis& d) {
  for (const ModelTerm& t : rig_as_given(task.system, task.records)) {
    const std::string name = parameter_name(task.system, t.term);
    for (const diagnosis::Parameter& p : d.extended.parameters)
      if (!t.known && p.name == name) bent(d, name, (factor - 1) * p.value);
  }
}

}  // namespace diagnosis::runs
