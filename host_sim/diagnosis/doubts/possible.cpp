#include "possible.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <map>

#include "../fit/error_rates.hpp"
#include "../fit/run_windows.hpp"
#include "../trial/attempt.hpp"
#include "../trial/merit.hpp"
#include "firmware/vocabulary/effect_table.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kMostOfAUnit = 1500;  // kilo for none, and a gain beside it
constexpr double kTurnedBy = 0.2;      // of a cable that is turned over, and its gain

// Of a link, for good.
bool takes_energy(const Term& t) { return t.link >= 0 && !firmware::row_of(effect_of(t.kind)).nature.conservative; }

// Whether anything from `added_from` on takes energy where the link's own dampers do.
bool damps_link(const Model& model, size_t added_from, int link) {
  return std::any_of(model.begin() + static_cast<std::ptrdiff_t>(added_from), model.end(),
                     [&](const ModelTerm& t) { return t.term.link == link && takes_energy(t.term); });
}

struct Damper {
  Kind kind;
  double shape, shape2, value, std;
  bool added;
};

// Bristles bend over a way that is short: they take what friction takes.
Damper damper_of(const ModelTerm& t, double std, bool added) {
  const Kind kind = t.term.kind == Kind::kPresliding ? Kind::kMissingCoulomb : t.term.kind;
  return {kind, t.term.shape, t.term.shape2, t.value, std, added};
}

std::vector<Damper> dampers_of(const State& s, const std::vector<Term>& added, int link) {
  const std::vector<Parameter> parameters = parameters_of(s.model);
  const std::vector<Determined> found = determined(s.fit, s.model);
  std::vector<Damper> list;
  for (size_t i = 0; i < s.model.size(); ++i) {
    const ModelTerm& t = s.model[i];
    if (t.term.link != link || !takes_energy(t.term) || t.host >= 0) continue;  // its host stands for it
    double std = 0;
    for (size_t p = 0; p < parameters.size() && p < found.size(); ++p)
      if (parameters[p].term == i && !parameters[p].shape) std = found[p].std;
    const bool one = std::any_of(added.begin(), added.end(), [&](const Term& a) { return a.same_place(t.term); });
    list.push_back(damper_of(t, std, one));
  }
  return list;
}

// Elongation and rate of a link along a window's run.
void motion_of(const rig_file::Link& link, const Prepared& p, const Window& window, const WindowRun& run, Vec& u,
               Vec& w) {
  u.setZero(window.length), w.setZero(window.length);
  for (const auto& [end, sign] : {std::pair{link.a, 1.0}, std::pair{link.b, -1.0}}) {
    const Guess& base = p.guess.back();
    if (end > 0)
      u += sign * run.x.row(end - 1).transpose(), w += sign * run.v.row(end - 1).transpose();
    else if (end == rig_file::kBase && base.given)
      u += sign * base.x.segment(window.from, window.length), w += sign * base.v.segment(window.from, window.length);
  }
}

// Whether those added put in more energy at any sample of a window than the others take, beyond what the intervals allow.
bool drive(const std::vector<Damper>& dampers, const Prepared& p, const Window& window, const Vec& u, const Vec& w) {
  for (Index k = 0; k < w.size(); ++k) {
    const double t_s = p.time_s(window.from + k);
    double power = 0, of_added = 0, variance = 0;
    for (const Damper& d : dampers) {
      const double each = w[k] * law(d.kind, u[k], w[k], law_time(t_s, d.shape, p), d.shape, d.shape2).force;
      power += d.value * each, of_added += d.added ? d.value * each : 0, variance += each * each * d.std * d.std;
    }
    if (of_added < 0 && power + kHalfOf95 * std::sqrt(variance) < 0) return true;
  }
  return false;
}

}  // namespace

bool is_number_of_rig(const ModelTerm& t) {
  return !t.added && (t.term.kind == Kind::kMass || t.term.kind == Kind::kStiffness || t.term.kind == Kind::kViscous ||
                      t.term.kind == Kind::kCoulomb);
}

bool below_nought(const State& s) {
  const std::vector<Parameter> parameters = parameters_of(s.model);
  const std::vector<Determined> found = determined(s.fit, s.model);
  for (size_t i = 0; i < parameters.size() && i < found.size(); ++i) {
    const ModelTerm& t = s.model[parameters[i].term];
    if (is_number_of_rig(t) && !parameters[i].shape && t.value + kHalfOf95 * found[i].std < 0) return true;
  }
  return false;
}

bool lightens_below_nought(const State& s, const std::vector<Candidate>& added) {
  const std::vector<Parameter> parameters = parameters_of(s.model);
  const std::vector<Determined> found = determined(s.fit, s.model);
  for (const Candidate& c : added)
    for (const Term& term : c.terms) {
      if (term.kind != Kind::kMassError) continue;
      double mass = 0, variance = 0;  // with what is carried there
      for (const ModelTerm& t : s.model)
        if ((t.term.kind == Kind::kMass || t.term.kind == Kind::kMassError) && t.term.dof == term.dof) mass += t.value;
      for (size_t i = 0; i < parameters.size() && i < found.size(); ++i)
        if (!parameters[i].shape && s.model[parameters[i].term].term.same_place(term))
          variance += found[i].std * found[i].std;
      if (mass + kHalfOf95 * std::sqrt(variance) < 0) return true;
    }
  return false;
}

bool turns_a_number(const State& beside, const State& with) {
  const std::vector<Parameter> p = parameters_of(beside.model);
  const std::vector<Determined> found = determined(beside.fit, beside.model);
  for (size_t i = 0; i < p.size() && i < found.size(); ++i) {
    const ModelTerm& t = beside.model[p[i].term];
    if (is_number_of_rig(t) && !p[i].shape && t.value > kSure * found[i].std && with.model[p[i].term].value < 0 &&
        !damps_link(with.model, beside.model.size(), t.term.link))
      return true;
  }
  return false;
}

bool drives_a_link(const Task& task, const State& s, const std::vector<Candidate>& added) {
  std::vector<Term> terms;
  for (const Candidate& c : added)
    std::copy_if(c.terms.begin(), c.terms.end(), std::back_inserter(terms), takes_energy);
  if (terms.empty()) return false;
  std::map<int, std::vector<Damper>> dampers;
  for (const Term& t : terms) dampers[t.link] = dampers_of(s, terms, t.link);
  Evaluator evaluator(task.system, s.model, task.records);
  std::atomic<bool> any{false};
  run_windows(evaluator, s.seen, false, [&](size_t i, const WindowRun& run, size_t) {
    const Window& window = s.seen[i];
    const Prepared& record = task.records[window.record];
    Vec u, w;
    for (const auto& [link, list] : dampers) {
      motion_of(task.system.links[static_cast<size_t>(link)], record, window, run, u, w);
      if (drive(list, record, window, u, w)) any = true;
    }
  });
  return any;
}

bool is_no_sensors(const State& with, const std::vector<Candidate>& added) {
  const auto asked = [&](const Term& t) {
    return std::any_of(added.begin(), added.end(), [&](const Candidate& c) { return c.terms[0].same_place(t); });
  };
  return std::any_of(with.model.begin(), with.model.end(), [&](const ModelTerm& t) {
    const bool of_force = t.term.kind == Kind::kForceGain;
    if ((!of_force && t.term.kind != Kind::kChannelGain) || !asked(t.term)) return false;
    const double reads = of_force ? 1 / (1 - t.value) : 1 + t.value;
    const bool turned = std::abs(reads + 1) < kTurnedBy;
    return !turned && !(reads > 1 / kMostOfAUnit && reads < kMostOfAUnit);
  });
}

bool cannot_be(const Task& task, const State& beside, const Attempt& with) {
  return turns_a_number(beside, with.state) || lightens_below_nought(with.state, with.candidates) ||
         drives_a_link(task, with.state, with.candidates);
}

bool can_stand(const Task& task, const State& beside, const Attempt& with) {
  return !cannot_be(task, beside, with) && !may_be_nought(with.state, beside.model.size());
}

}  // namespace diagnosis::runs
