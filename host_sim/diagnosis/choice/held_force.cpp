#include "held_force.hpp"

#include <algorithm>

#include "attempt.hpp"

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

}  // namespace

bool held_force(const Task& task, std::vector<Prepared>& records, const Choice& choice) {
  const std::vector<Candidate> delays = delays_of(records);
  const double noise = noise_share(choice.base_left, choice.base.fit);
  if (delays.empty() || !choice.base.fit.ok) return false;
  const auto hold = [&](bool held) {
    for (Prepared& p : records) p.held = held;
  };
  Attempt with;
  with.state = choice.base;
  hold(true);
  settle(task, with.state, kTrialSteps);
  hold(false);
  if (!with.state.fit.ok) return false;
  with.error = error_over(with.state.fit, choice.base.fit);
  with.unseen = error_over(with.state.unseen_fit, choice.base.unseen_fit);
  // of a short record a window or two are by far the loudest: as a share of their own, as attempts in another's place are judged
  const double z = std::max(paired_z(choice.base.fit, with.state.fit), paired_share_z(choice.base.fit, with.state.fit));
  if (!(z > (noise < kMostlyNoise ? kSure : kNamed)) || !unseen_agrees(with) || share_of(with, noise) < kShare)
    return false;
  for (const Candidate& c : delays) {
    const Attempt late = attempt(task, choice.base, {c}, {{0.0}}, kTrialSteps);
    const double better =
        std::max(paired_z(late.state.fit, with.state.fit), paired_share_z(late.state.fit, with.state.fit));
    if (late.state.fit.ok && !(better > kByChance)) return false;
  }
  hold(true);
  return true;
}

}  // namespace diagnosis::runs
