// The rig as given, fitted over the longest windows that it can follow.
#include <algorithm>

#include "../first_values/start.hpp"
#include "../motion/drive_noise.hpp"
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
  settle_unseen(task, now);
  choice.base = choice.final = now;
  if (now.fit.ok) choice.base_left = choice.final_left = left_by(task.system, task.records, now);
  // a noisy force shakes the simulation, though the rig file is right; one that is much noise, with what it is off on the mean
  choice.base_fits_nothing = !massless(now.model) && !follows(task, now, false) &&
                             (!now.fit.ok || (beyond_noise(choice.base_left) && !drives_are_much_noise(task.records)));
  return choice;
}

}  // namespace diagnosis::runs
