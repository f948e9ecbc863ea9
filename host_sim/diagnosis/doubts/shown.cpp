#include "shown.hpp"

#include <algorithm>
#include <cmath>

#include "../candidates/candidates.hpp"
#include "../motion/link_motion.hpp"

namespace diagnosis::runs {
namespace {

// Pitches that the way has to hold: along less of a sine a cubic spring is as good a story.
constexpr double kRepeats = 1.5;
// Periods of the motion that a drift has to take: coefficient, drift and time constant are three numbers, and each period shows
// one damping.
constexpr double kDriftPeriods = 3;
constexpr double kBeyondBand = 0.05;    // of a force's samples: as many as show the end of a band
constexpr double kOneMotion = 0.9;      // correlation of two channels that see the same motion
constexpr double kContradiction = 0.1;  // between two gains of a channel: noise and filters make less

// Whether a link's bristles take longer than a sample to bend from a reversal on (half a t^2 at its rms acceleration). What
// a friction force does within one sample is what filters and thinning make of its jump. Where a force is measured against an
// imposed motion no simulation stands between: a filter's lag is the force's delay then, and that is its rival.
bool bends_slowly(const Task& task, const Term& presliding) {
  if (massless(task.system.rig)) return true;
  const rig_file::Link& l = task.system.links[static_cast<size_t>(presliding.link)];
  for (const Prepared& p : task.records) {
    const Vec a = motion_of(l, p, &Guess::a);
    const double rms = std::sqrt(a.squaredNorm() / static_cast<double>(a.size()));
    if (2 * presliding.shape > rms * p.step_s * p.step_s) return true;
  }
  return false;
}

// Bristles that bend all along a link's way never slide: they are a spring.
bool slides(const Task& task, const Term& presliding) {
  return presliding.shape < way_of(task.system, task.records, presliding.link);
}

// A force that its dead band holds nearly all the time is smaller than its reading, and nothing shows the band's end.
bool leaves_its_band(const Task& task, const Term& band) {
  double beyond = 0, all = 0;
  for (const Prepared& p : task.records) {
    const Vec& f = p.force[static_cast<size_t>(band.dof)];
    beyond += static_cast<double>((f.array().abs() > band.shape).count()), all += static_cast<double>(f.size());
  }
  return beyond > kBeyondBand * all;
}

// A hidden mass that no balance would tell from the rig's own is none: in a decay whose frequency passes it it is a step of its phase.
bool weighs_enough(const Task& task, const ModelTerm& hidden) {
  const rig_file::Coefficient& mass = task.system.rig.dofs[static_cast<size_t>(hidden.term.dof)].mass_kg;
  return mass.estimate || hidden.value >= kTrifle * mass.value;
}

bool drifts(const Task& task, const Term& damper) {
  if (damper.shape <= 0) return true;  // all the time, or from record to record
  return std::any_of(task.records.begin(), task.records.end(),
                     [&](const Prepared& p) { return damper.shape > kDriftPeriods * p.period_s; });
}

// Gain of a rate's channel over that of its integral's: what the rate adds up to over a quarter of a period against what the
// other moves in that time. 0 where the two do not see one motion.
double gain_ratio(const Prepared& p, const Vec& integral, const Vec& rate) {
  const Index part = std::max<Index>(1, static_cast<Index>(0.25 * p.period_s / p.step_s));
  const Index count = p.samples - part;
  if (count < 2 * part) return 0;
  Vec moved = integral.tail(count) - integral.head(count), sum(count);
  double running = 0;
  for (Index i = 0; i < part; ++i) running += 0.5 * (rate[i] + rate[i + 1]);
  for (Index i = 0; i < count; ++i) {
    sum[i] = running * p.step_s;
    if (i + 1 < count) running += 0.5 * (rate[i + part] + rate[i + part + 1] - rate[i] - rate[i + 1]);
  }
  moved.array() -= moved.mean(), sum.array() -= sum.mean();
  const double size = moved.norm() * sum.norm(), together = moved.dot(sum);
  if (!(size > 0) || std::abs(together) < kOneMotion * size) return 0;
  return std::copysign(sum.norm() / moved.norm(), together);
}

bool contradicted(const Task& task, const ModelTerm& gain) {
  for (const Prepared& p : task.records) {
    const MotionTrace* own = trace_of(p, gain.term.dof, gain.term.quantity);
    for (const int next : {gain.term.quantity - 1, gain.term.quantity + 1}) {
      const MotionTrace* other = trace_of(p, gain.term.dof, next);
      if (!own || !other) continue;
      const bool rate = next < gain.term.quantity;
      const double ratio = rate ? gain_ratio(p, other->y, own->y) : gain_ratio(p, own->y, other->y);
      if (ratio == 0) continue;
      if (std::abs((rate ? ratio : 1 / ratio) - (1 + gain.value)) > kContradiction) return true;
    }
  }
  return false;
}

}  // namespace

bool shown(const Task& task, const ModelTerm& t) {
  switch (t.term.kind) {
    case Kind::kPresliding:
      return bends_slowly(task, t.term) && slides(task, t.term);
    case Kind::kResonance:
      return weighs_enough(task, t);
    case Kind::kDeadBand:
      return leaves_its_band(task, t.term);
    case Kind::kDriftingViscous:
      return drifts(task, t.term);
    case Kind::kCogging:
      return kRepeats * t.term.shape < way_of(task.system, task.records, t.term.link);
    case Kind::kChannelGain:
      return !contradicted(task, t);
    default:
      return true;
  }
}

bool all_shown(const Task& task, const Model& model) {
  return std::all_of(model.begin(), model.end(), [&](const ModelTerm& t) { return !t.added || shown(task, t); });
}

}  // namespace diagnosis::runs
