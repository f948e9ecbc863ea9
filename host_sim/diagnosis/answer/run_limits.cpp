#include "run_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../doubts/materiality.hpp"
#include "../doubts/needless.hpp"
#include "../first_screen/limits.hpp"
#include "../motion/link_motion.hpp"
#include "../numbers/numbers_of.hpp"
#include "../sensors/sensor_check.hpp"
#include "../terms/naming.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// Strengths that nobody records with: a hundred times what damps the link, ten times what a channel reads, a quarter of a period late.
constexpr double kBeyondDamping_percent = 1e4, kBeyondReading = 10, kBeyondPeriod = 0.25;

// In standard deviations of the windows fitted: it has to be sure there and to pay on those that are left, which are fewer, or
// to be beyond doubt where those cannot tell.
double needed_deviations(const State& base) {
  double seen = 0, unseen = 0;
  for (const Window& w : base.seen) seen += static_cast<double>(w.length);
  for (const Window& w : base.unseen) unseen += static_cast<double>(w.length);
  const double sure = seen_in_95_of_100(kSure * kSure);
  const double alone = seen_in_95_of_100(kNamed * kNamed);
  if (!(unseen > 0)) return alone;
  return std::clamp(seen_in_95_of_100(kByChance * kByChance) * std::sqrt(seen / unseen), sure, alone);
}

// What one number of their own would bring, of laws without a shape.
std::vector<Candidate> plain_candidates(const Task& task, const State& base) {
  std::vector<Candidate> list = candidates_beside(task.system, base.model, task.records, false);
  list.erase(
      std::remove_if(list.begin(), list.end(), [](const Candidate& c) { return c.host >= 0 || c.complexity > 0; }),
      list.end());
  return list;
}

Screen screened(const Task& task, const State& base, std::vector<Candidate> candidates) {
  for (Candidate& c : candidates) c.sign = 0;  // how sure a number is does not depend on which way it came out
  return screen(task.system, task.records, base.model, base.seen, base.fit, candidates, 0);
}

// The coefficient that is seen in 95 of 100 such records.
double needed_strength(const Screened& one, double deviations) {
  return one.value.empty() || !(std::abs(one.z) > 0) ? 0 : deviations * std::abs(one.value[0] / one.z);
}

// The coefficient from which windows gain what makes a cause worth naming (materiality.hpp), and what is missed without it is more than
// of a rig that is as good as right. motion_error: of the rig as given.
double material_strength(const Screened& one, double motion_error) {
  if (one.value.empty() || !(one.gain > 0)) return 0;
  const double more = std::sqrt(kLeastGain * kLeastGain - 1), enough = kAsGoodAsRight / motion_error;
  return std::abs(one.value[0]) / std::sqrt(one.gain) * std::max(more, enough > 1 ? enough : 0);
}

// rms over all records of the force that a law makes along a link's measured motion, per unit of its coefficient.
double force_rms(const Task& task, const Term& t) {
  const rig_file::Link& link = task.system.links[static_cast<size_t>(t.link)];
  double square = 0, samples = 0;
  for (const Prepared& p : task.records) {
    const Vec u = motion_of(link, p, &Guess::x), w = motion_of(link, p, &Guess::v);
    for (Index k = 0; k < p.samples; ++k)
      square += std::pow(law(t.kind, u[k], w[k], law_time(p.time_s(k), t.shape, p), t.shape, t.shape2).force, 2);
    samples += static_cast<double>(p.samples);
  }
  return std::sqrt(square / std::max(1.0, samples));
}

// The same of what needs no law: a mass takes its acceleration, a gain the force itself. 0 of anything else.
double dof_force_rms(const Task& task, const Term& t) {
  double square = 0, samples = 0;
  for (const Prepared& p : task.records) {
    const size_t dof = static_cast<size_t>(t.dof);
    if (t.kind == Kind::kMassError) square += p.guess[dof].a.squaredNorm();
    if (t.kind == Kind::kForceGain) square += p.force[dof].squaredNorm();
    samples += static_cast<double>(p.samples);
  }
  return std::sqrt(square / std::max(1.0, samples));
}

// rms of what the dampers of each of the rig file's links take, about: viscous force and friction side by side.
std::vector<double> damping_of_links(const Task& task, const Model& model) {
  std::vector<double> list(task.system.known_links, 0.0);
  for (const ModelTerm& t : model)
    if ((t.term.kind == Kind::kViscous || t.term.kind == Kind::kCoulomb) && t.term.link >= 0 &&
        static_cast<size_t>(t.term.link) < list.size())
      list[static_cast<size_t>(t.term.link)] += std::abs(t.value) * force_rms(task, t.term);
  return list;
}

bool of_time(Kind kind) { return kind == Kind::kChannelDelay || kind == Kind::kForceDelay || kind == Kind::kBaseDelay; }

// Whether a limit is no answer: these records do not show the effect, however strong it is.
bool beyond_all(const Task& task, Kind kind, const DetectionLimit& limit) {
  if (of_time(kind)) return limit.strength > kBeyondPeriod * task.records[0].period_s;
  if (kind == Kind::kChannelGain || kind == Kind::kForceGain) return limit.strength > kBeyondReading;
  return limit.percent_of_damping_force > kBeyondDamping_percent;
}

}  // namespace

void raise_limits(const Task& task, const State& base, std::vector<DetectionLimit>& limits) {
  if (!base.fit.ok || limits.empty()) return;
  const std::vector<Candidate> candidates = plain_candidates(task, base);
  const double deviations = needed_deviations(base);
  for (const Screened& one : screened(task, base, candidates).singles) {
    const Term& t = candidates[one.candidate].terms[0];
    const double needed = needed_strength(one, deviations);
    const NamedPlace place{word_of(t.kind), place_of(task.system, t, FusedRecord())};
    for (DetectionLimit& limit : limits) {
      if (limit.effect != place.effect || limit.where != place.where || !(needed > limit.strength)) continue;
      limit.percent_of_damping_force *= needed / limit.strength, limit.strength = needed;
    }
  }
}

std::vector<DetectionLimit> limits_of_runs(const Task& task, const State& base) {
  std::vector<DetectionLimit> limits;
  if (!base.fit.ok) return limits;
  const std::vector<Candidate> candidates = plain_candidates(task, base);
  const Screen s = screened(task, base, candidates);
  const double deviations = needed_deviations(base);
  // What a candidate gains is a share of all that is left, the steps of the channels too: of those the motion's error knows nothing.
  const double error = std::max(motion_error(task, base), 1 / std::sqrt(motion_over_error(task, base)));
  const std::vector<double> damping = damping_of_links(task, base.model);
  for (size_t i = 0; i < candidates.size(); ++i) {
    const Term& t = candidates[i].terms[0];
    const NamedPlace place = named_place(task, t);
    const auto one = std::find_if(s.singles.begin(), s.singles.end(),
                                  [&](const Screened& o) { return candidates[o.candidate].same_place(candidates[i]); });
    const double strength =
        one == s.singles.end() ? kNever : std::max(needed_strength(*one, deviations), material_strength(*one, error));
    if (!(strength > 0)) continue;
    DetectionLimit limit{place.effect, place.where, strength, unit_of(t.kind, rotates(task.system, t)), 0};
    const double force = strength * (t.link >= 0 ? force_rms(task, t) : t.dof >= 0 ? dof_force_rms(task, t) : 0);
    const double beside = damping_at(task.system, damping, t);
    limit.percent_of_damping_force = std::isinf(strength) ? kNever : beside > 0 ? 100 * force / beside : 0;
    if (beyond_all(task, t.kind, limit)) limit.strength = limit.percent_of_damping_force = kNever;
    limits.push_back(limit);
  }
  return limits;
}

}  // namespace diagnosis::runs
