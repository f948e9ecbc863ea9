#include "held_force.hpp"

#include <algorithm>

#include "../choice/round.hpp"
#include "../trial/attempt.hpp"
#include "../trial/merit.hpp"
#include "../trial/paired.hpp"

namespace diagnosis::runs {
namespace {

// What could be taken for a hold: delays of the forces, and of the channels where they act.
std::vector<Candidate> delays_of(const std::vector<Prepared>& records) {
  std::vector<Candidate> list;
  const auto add = [&](Term t) {
    Candidate c;
    c.terms = {t};
    list.push_back(c);
  };
  const std::vector<Vec>& force = records[0].force;
  for (size_t dof = 0; dof < force.size(); ++dof)
    if (force[dof].size() > 0) add(on_dof(Kind::kForceDelay, static_cast<int>(dof)));
  for (const MotionTrace& t : records[0].traces) {
    if (force[static_cast<size_t>(t.dof)].size() == 0) continue;
    Term channel = on_dof(Kind::kChannelDelay, t.dof);
    channel.quantity = t.quantity;
    add(channel);
  }
  return list;
}

// Of a short record a window or two are by far the loudest: as a share of their own, as attempts in another's place are judged.
double better_by(const State& than, const State& now) {
  return std::max(paired_z(than.fit, now.fit), paired_share_z(than.fit, now.fit));
}

// The windows with a held force, beside a model that was fitted with a smooth one; it is smooth again afterwards.
Attempt with_hold(const Task& task, std::vector<Prepared>& records, const State& beside) {
  const auto hold = [&](bool held) {
    for (Prepared& p : records) p.held = held;
  };
  Attempt with;
  with.state = beside;
  hold(true);
  settle(task, with.state, kTrialSteps);
  hold(false);
  if (!with.state.fit.ok) return with;
  with.error = error_over(with.state.fit, beside.fit);
  with.unseen = error_over(with.state.unseen_fit, beside.unseen_fit);
  return with;
}

bool pays(const Attempt& with, const State& beside, double noise) {
  return with.state.fit.ok && better_by(beside, with.state) > (noise < kMostlyNoise ? kSure : kNamed) &&
         unseen_agrees(with) && share_of(with, noise) >= kShare;
}

// The one cause that leaves least beside the rig as given, of those that the linearisation promises most.
Attempt best_single(const Task& task, const State& base, const Left& left, double noise) {
  const std::vector<Candidate> all =
      candidates_beside(task.system, base.model, task.records, left.worst() > kPlainlyLeft);
  const Screen s = screen(task.system, task.records, base.model, base.seen, base.fit, all, 0);
  Attempt best;
  size_t tried = 0;
  for (const Screened& one : s.singles) {
    if (tried++ == kShortList) break;
    const Attempt other = attempt(task, base, all, one, noise);
    if (!other.state.fit.ok || other.rounds || !unseen_agrees(other)) continue;
    if (!best.state.fit.ok || whole_error(other) < whole_error(best)) best = other;
  }
  return best;
}

}  // namespace

bool held_force(const Task& task, std::vector<Prepared>& records, const Choice& choice) {
  const std::vector<Candidate> delays = delays_of(records);
  const State& base = choice.base;
  const double noise = noise_share(choice.base_left, base.fit);
  if (delays.empty() || !base.fit.ok) return false;
  const Attempt with = with_hold(task, records, base);
  if (!pays(with, base, noise)) return false;
  for (const Candidate& c : delays) {
    const Attempt late = attempt(task, base, {c}, {{0.0}}, kTrialSteps);
    if (late.state.fit.ok && !(better_by(late.state, with.state) > kByChance)) return false;
  }
  const Attempt other = best_single(task, base, choice.base_left, noise);
  if (other.state.fit.ok && better_by(with.state, other.state) > kByChance) {
    const double left_noise = noise_share(left_by(task.system, task.records, other.state), other.state.fit);
    if (!pays(with_hold(task, records, other.state), other.state, left_noise)) return false;
  }
  for (Prepared& p : records) p.held = true;
  return true;
}

}  // namespace diagnosis::runs
