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

namespace {

void mark(const Task& task, const Rival& r, Diagnosis& d) {
  if (r.error > kWorth) return;  // listed to be on the safe side, and no equal
  const std::string rival = words(named_place(task, r.candidate.terms[0]));
  for (const Move& m : r.moves) {
    const std::string name = parameter_name(task.system, m.term);
    if (bent(d, name, m.by)) tell(d, name, m.by, rival);
  }
}

}  // namespace

void mark_rows_rivals(const Task& task, const Choice& fitted, const State& with_it, Diagnosis& d) {
  const State& base = fitted.base;
  if (d.ambiguous_with.empty() || !with_it.fit.ok) return;
  const double noise = noise_share(fitted.base_left, base.fit);
  const std::vector<Candidate> all = candidates_beside(task.system, base.model, task.records, false);
  const auto is_equal = [&](const Candidate& c) {
    const NamedPlace place = named_place(task, c.terms[0]);
    return std::find(d.ambiguous_with.begin(), d.ambiguous_with.end(), place) != d.ambiguous_with.end();
  };
  std::vector<Candidate> tried;
  for (const Screened& one : screen(task.system, task.records, base.model, base.seen, base.fit, all, 0).singles) {
    const Candidate& c = all[one.candidate];
    const auto same = [&](const Candidate& o) { return o.same_place(c); };
    if (!is_equal(c) || std::any_of(tried.begin(), tried.end(), same)) continue;
    tried.push_back(c);
    const Attempt rival = attempt(task, base, all, one, noise);
    if (!rival.state.fit.ok) continue;
    std::vector<Move> moves;
    for (size_t i = 0; i < base.model.size(); ++i)
      if (!base.model[i].known && base.model[i].host < 0)
        moves.push_back({base.model[i].term, rival.state.model[i].value - with_it.model[i].value});
    mark(task, {c, error_over(rival.state.fit, with_it.fit), moves}, d);
  }
}

void mark_between_rivals(const Task& task, const Choice& choice, Diagnosis& d) {
  for (const Named& named : choice.named)
    for (const Rival& r : named.rivals) mark(task, r, d);
}

void mark_scaled(const Task& task, double factor, Diagnosis& d) {
  for (const ModelTerm& t : rig_as_given(task.system, task.records)) {
    const std::string name = parameter_name(task.system, t.term);
    for (const diagnosis::Parameter& p : d.extended.parameters)
      if (!t.known && p.name == name) bent(d, name, (factor - 1) * p.value);
  }
}

}  // namespace diagnosis::runs
