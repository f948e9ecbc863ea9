// The rig as given, fitted over the longest windows that it can follow.
#include <algorithm>

#include "../first_values/start.hpp"
#include "../motion/drive_noise.hpp"
#include "../motion/link_motion.hpp"
#include "../trial/settle.hpp"
#include "horizon.hpp"

namespace diagnosis::runs {
namespace {

// Dry friction makes valleys of a window's error, and where the first values are poor the nearest is not the lowest. The rig without its
// unknown frictions is followed from farther away; from there they start at nought. What it follows where the rig with them
// from its own first values followed nothing is gone on from.
void from_smooth_start(const Task& task, const Model& start, State& s, double& periods) {
  const auto unknown_friction = [](const ModelTerm& t) { return t.term.kind == Kind::kCoulomb && !t.known; };
  if (massless(start) || follows(task, s) || std::none_of(start.begin(), start.end(), unknown_friction)) return;
  State smooth;
  smooth.model = start;
  for (ModelTerm& t : smooth.model)
    if (unknown_friction(t)) t.known = true, t.value = 0;
  const double reached = horizon(task, smooth, longest_horizon(task.records), false);
  for (size_t i = 0; i < start.size(); ++i) smooth.model[i].known = start[i].known;
  smooth.fit = fit(task.system, task.records, smooth.model, smooth.seen, kBaseSteps);
  if (follows(task, smooth)) s = smooth, periods = reached;
}

// The friction that takes as much as a damper does over all records' motion: c times the integral of w^2 over that of |w|.
double friction_like(const Task& task, const rig_file::Link& link, double viscous) {
  const UnitWork work = unit_work_of(link, task.records);
  return work.coulomb > 0 ? viscous * work.viscous / work.coulomb : 0;
}

// The other end of the valley: what the balance of forces shares between a link's damper and its friction is all friction's. Where the rig
// with its frictions leaves more than a right one, it is fitted from there too, and the better is gone on from.
void from_frictional_start(const Task& task, const Model& start, State& s) {
  if (massless(start) || !s.fit.ok || motion_error(task, s) < kAsGoodAsRight) return;
  State rough = s;
  rough.model = start;
  bool any = false;
  for (ModelTerm& friction : rough.model)
    for (ModelTerm& damper : rough.model) {
      if (friction.term.kind != Kind::kCoulomb || damper.term.kind != Kind::kViscous || friction.known ||
          damper.known || friction.term.link != damper.term.link || !(damper.value > 0))
        continue;
      const rig_file::Link& link = task.system.links[static_cast<size_t>(friction.term.link)];
      friction.value = std::max(0.0, friction.value) + friction_like(task, link, damper.value);
      damper.value = 0, any = true;
    }
  if (!any) return;
  forget_states(rough);
  rough.fit = fit(task.system, task.records, rough.model, rough.seen, kBaseSteps);
  if (rough.fit.ok && error_over(rough.fit, s.fit) < 1) s = rough;
}

}  // namespace

Choice rig_fitted(const Task& task) {
  Choice choice;
  State now;
  now.model = rig_as_given(task.system, task.records);
  start_values(task.system, task.records, now.model);
  const Model start = now.model;
  choice.periods = horizon(task, now, longest_horizon(task.records), massless(now.model));
  from_smooth_start(task, start, now, choice.periods);
  if (!massless(start) && !follows(task, now, false)) over_longer(task, start, choice.periods, now);
  from_frictional_start(task, start, now);
  settle_unseen(task, now);
  choice.base = choice.final = now;
  if (now.fit.ok) choice.base_left = choice.final_left = left_by(task.system, task.records, now);
  // a noisy force shakes the simulation, though the rig file is right; one that is much noise, with what it is off on the mean
  choice.base_fits_nothing = !massless(now.model) && !follows(task, now, false) &&
                             (!now.fit.ok || (beyond_noise(choice.base_left) && !drives_are_much_noise(task.records)));
  return choice;
}

}  // namespace diagnosis::runs
