// What is asked of a prepared record, and the guesses of its motion.
#include "prepared.hpp"

#include <algorithm>

#include "../record/motion.hpp"
#include "guess.hpp"
#include "period.hpp"

namespace diagnosis::runs {

const MotionTrace* trace_of(const Prepared& p, int dof, int quantity) {
  for (const MotionTrace& t : p.traces)
    if (t.dof == dof && t.quantity == quantity) return &t;
  return nullptr;
}

double motion_square(const Prepared& p, const MotionTrace& trace, Index from, Index length) {
  const auto y = trace.y.segment(from, length);
  if (!trace.travels) return (y.array() - y.mean()).square().sum();
  const double of_speed =
      rms_about_mean(p.guess[static_cast<size_t>(trace.dof)].v) * static_cast<double>(length) * p.step_s / kTwoPi;
  return std::max(square_off_line(y), static_cast<double>(length) * of_speed * of_speed);
}

void renew_motion(Prepared& p) {
  p.guess.clear();
  for (size_t d = 0; d < p.force.size(); ++d) {
    std::vector<const Vec*> measured(3, nullptr);
    for (const MotionTrace& t : p.traces)
      if (t.dof == static_cast<int>(d)) measured[static_cast<size_t>(t.quantity)] = &t.y;
    if (!measured[0] && !measured[1] && !measured[2])
      throw CannotAnswer(p.file + ": no displacement, velocity or acceleration of DOF " + std::to_string(d + 1) +
                         "; measure one of them");
    Vec against_base;
    if (p.base.ridden) against_base = *measured[2] - p.base.reading[2], measured[2] = &against_base;
    p.guess.push_back(guess_of(measured, p.step_s, p.smooth_half, {p.slow_half}));
    if (p.base.ridden) p.guess.back().a += p.base.reading[2];
  }
  p.guess.push_back({});
  renew_base(p);
  p.period_s = period_of(p);
}

}  // namespace diagnosis::runs
