#include "hum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../doubts/trifles.hpp"
#include "../residual/lines.hpp"
#include "../terms/naming.hpp"
#include "force_hum.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kOwnShare = 0.5;  // of a hum that is left: more than that the simulation has made

std::string unit_of(const MotionTrace& t) {
  constexpr const char *kUnits[] = {"m", "m/s", "m/s^2"}, *kAngles[] = {"rad", "rad/s", "rad/s^2"};
  return (t.channel.find("_rad") != std::string::npos ? kAngles : kUnits)[t.quantity];
}

Cause cause_of(const MotionTrace& t, const Hum& hum) {
  Cause c;
  c.effect = "mains_hum", c.where = "channel " + t.channel;
  c.significance = hum.over, c.taken_out = true;
  c.parameters.push_back({"mains_hum[" + t.channel + "]", hum.amplitude, unit_of(t), 0, true});
  c.parameters.push_back({"mains_frequency[" + t.channel + "]", hum.hertz, "Hz", 0, false});
  return c;
}

// Whether the force of the channel's DOF holds as much of a wave as would show as that hum where it does not act: mass times
// acceleration, as springs matter little that far above the motion. Then the channel is not told from the force's.
bool force_may_have_it(const Task& task, const MotionTrace& t, const Hum& hum) {
  const size_t dof = static_cast<size_t>(t.dof);
  const double by_rate = std::pow(kTwoPi * hum.hertz, 2 - t.quantity);
  const double needed = hum.amplitude * by_rate * task.system.rig.dofs[dof].mass_kg.value;
  double held = 0;
  for (const Prepared& p : task.records) held = std::max(held, wave_at_mains(p.force[dof], p.step_s, hum.hertz));
  return held > 0 && held * kOneOfThem > needed;
}

// Whether the channel itself has at least half of what the simulation leaves of it. Where it has not, the simulation makes it: of a force
// that is said to act and does not.
bool shows_itself(const Task& task, size_t channel, const Hum& hum) {
  double own = 0;
  for (const Prepared& p : task.records) own = std::max(own, wave_at_mains(p.traces[channel].y, p.step_s, hum.hertz));
  return own > kOwnShare * hum.amplitude;
}

// What a motion channel's hum is weighed against where no other motion channel is: the most that a force has of it, over its rms.
double most_of_forces(const Task& task, double hertz) {
  double most = 0;
  for (const Prepared& p : task.records)
    for (const Vec& force : p.force) {
      const double rms = force.size() ? rms_about_mean(force) : 0;
      if (rms > 0) most = std::max(most, wave_at_mains(force, p.step_s, hertz) / rms);
    }
  return most;
}

}  // namespace

std::vector<double> shares_of_signals(const std::vector<MotionTrace>& traces, const std::vector<Hum>& hum) {
  std::vector<double> shares(traces.size());
  for (size_t i = 0; i < traces.size(); ++i) {
    const double rms = rms_about_mean(traces[i].y);
    shares[i] = rms > 0 ? hum[i].amplitude / rms : 0;
    if (shares[i] < kTrifle) shares[i] = 0;
  }
  return shares;
}

const std::vector<Hum>& hum_seen(const Choice& choice) {
  return choice.hum_taken.empty() ? choice.final_left.hum : choice.hum_taken;
}

void name_hum(const Task& task, const Choice& choice, Diagnosis& d) {
  if (massless(choice.final.model)) return;  // without masses what is left are forces
  name_hum(task, hum_seen(choice), d);
}

void name_hum(const Task& task, const std::vector<Hum>& hum, Diagnosis& d) {
  const std::vector<MotionTrace>& traces = task.records[0].traces;
  if (hum.size() != traces.size()) return;
  size_t worst = 0, with_hum = 0;
  std::vector<double> share = shares_of_signals(traces, hum);
  for (size_t i = 0; i < traces.size(); ++i) {
    if (share[i] > 0 && hum[i].driven && !shows_itself(task, i, hum[i])) share[i] = 0;
    with_hum += share[i] > 0;
    if (share[i] > share[worst]) worst = i;
  }
  if (with_hum == 0) return;
  double next = 0;
  for (size_t i = 0; i < share.size(); ++i)
    if (i != worst) next = std::max(next, share[i]);
  if (share.size() == 1) next = most_of_forces(task, hum[worst].hertz);
  const bool borne_out = std::any_of(traces.begin(), traces.end(), [&](const MotionTrace& t) {
    return t.dof == traces[worst].dof && t.quantity != traces[worst].quantity;
  });
  if (share[worst] > kOneOfThem * next && (borne_out || !hum[worst].driven)) {
    const Cause c = cause_of(traces[worst], hum[worst]);
    if (d.names(c.effect, c.where)) return;
    d.causes.push_back(c);
    if (d.verdict == Verdict::kNone) d.verdict = Verdict::kExplained;
    if (borne_out || !force_may_have_it(task, traces[worst], hum[worst])) return;
    const size_t dof = static_cast<size_t>(traces[worst].dof);
    d.ambiguous_with.push_back({c.effect, "channel " + force_channel(task.system.rig, dof)});
    if (d.verdict == Verdict::kExplained) d.verdict = Verdict::kAmbiguous;
    return;
  }
  if (hum[worst].driven) return;
  char text[120];
  std::snprintf(text, sizeof text, "%s %.0f Hz lies on %zu of %zu motion channels: it is left out of the judgement",
                kHumTold, hum[worst].hertz, with_hum, traces.size());
  d.advice.push_back(text);
}

}  // namespace diagnosis::runs
