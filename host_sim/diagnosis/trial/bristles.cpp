#include "bristles.hpp"

#include <algorithm>

#include "judge.hpp"
#include "merit.hpp"
#include "paired.hpp"

namespace diagnosis::runs {

Attempt damped(const Task& task, const State& beside, Attempt bristles) {
  Candidate c = bristles.candidates[0];
  keep_shape(bristles.state.model, c);
  Term& t = c.terms[0];
  t.shape2 = t.shape / rate_of(task.system, task.records, t.link);
  const Attempt a = attempt(task, beside, {c}, {{bristles.state.model.back().value}}, 2 * kTrialSteps);
  if (!a.state.fit.ok || a.rounds || whole_error(a) >= whole_error(bristles)) return bristles;
  return paired_z(all_blocks(bristles.state), all_blocks(a.state)) > kSure ? a : bristles;
}

bool is_bristles(const Attempt& a) {
  return a.candidates.size() == 1 && a.candidates[0].terms[0].kind == Kind::kPresliding && a.state.fit.ok && !a.rounds;
}

State rounded(const Task& task, const State& beside, const std::vector<Attempt>& tried) {
  std::vector<Candidate> list;
  std::vector<std::vector<double>> start;
  for (const Attempt& a : tried)
    if (a.rounds && a.state.fit.ok && a.candidates.size() == 1 && paired_z(beside.fit, a.state.fit) > kNamed) {
      list.push_back(a.candidates[0]), start.push_back({0.0});
      keep_shape(a.state.model, list.back());
    }
  return list.empty() ? State{} : attempt(task, beside, list, start, kTrialSteps).state;
}

Attempt without_bristles(const Task& task, const State& beside, const Attempt& bristles) {
  Attempt a;
  a.state = bristles.state;
  Model& model = a.state.model;
  const auto term = std::find_if(model.begin(), model.end(), [&](const ModelTerm& t) {
    return t.added && t.term.same_place(bristles.candidates[0].terms[0]);
  });
  if (term == model.end()) return Attempt();
  if (term->host >= 0) {
    const auto at = static_cast<int>(term - model.begin());
    model.erase(term);  // the rig's own friction, as it was fitted with them
    for (ModelTerm& t : model) t.host -= t.host > at;
  } else {
    Candidate dry = bristles.candidates[0];
    dry.terms = {on_link(Kind::kMissingCoulomb, term->term.link)}, dry.complexity = 0;
    term->term = dry.terms[0], term->shape_free = term->shape2_free = false;
    a.candidates = {dry};
  }
  for (std::vector<Window>* windows : {&a.state.seen, &a.state.unseen})
    for (Window& w : *windows)  // the bristles' state lies between those of the motion and the channels' zeros
      w.state.resize(0);
  approach(task.system, task.records, a.state.model, a.state.seen, kTrialSteps, true);
  settle(task, a.state, kTrialSteps);
  judge(task, beside, false, a);
  return a;
}

}  // namespace diagnosis::runs
