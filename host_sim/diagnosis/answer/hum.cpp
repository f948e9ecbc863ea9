#include "hum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../choice/lines.hpp"
#include "../terms/naming.hpp"
#include "force_hum.hpp"
#include "trifles.hpp"

namespace diagnosis::runs {
namespace {

constexpr const char* kHumTold = "a hum of";
constexpr double kAsLoudAsNoise = 2;  // misfit of a hum that has the power of all noise

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

// Per channel, 0 below a trifle.
std::vector<double> shares_of_signals(const std::vector<MotionTrace>& traces, const std::vector<Hum>& hum) {
  std::vector<double> shares(traces.size());
  for (size_t i = 0; i < traces.size(); ++i) {
    const double rms = rms_about_mean(traces[i].y);
    shares[i] = rms > 0 ? hum[i].amplitude / rms : 0;
    if (shares[i] < kTrifle) shares[i] = 0;
  }
  return shares;
}

// Every motion channel has as much of it. What a force answers to, or is said to, falls off from mass to mass, and from one
// quantity to the next.
bool alike_in_all(const std::vector<MotionTrace>& traces, const std::vector<Hum>& hum) {
  if (traces.size() < 2 || hum.size() != traces.size()) return false;
  const std::vector<double> shares = shares_of_signals(traces, hum);
  const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
  return *least > 0 && *most <= kOneOfThem * *least;
}

// Whether the force of the channel's DOF holds as much of a wave as would show as that hum where it does not act: mass times
// acceleration, as springs matter little that far above the motion. Then the channel is not told from the force's.
bool force_may_have_it(const Task& task, const MotionTrace& t, const Hum& hum) {
  const size_t dof = static_cast<size_t>(t.dof);
  if (dof >= task.system.rig.dofs.size()) return false;
  const double by_rate = std::pow(kTwoPi * hum.hertz, 2 - t.quantity);
  const double needed = hum.amplitude * by_rate * task.system.rig.dofs[dof].mass_kg.value;
  double held = 0;
  for (const Prepared& p : task.records)
    if (p.force[dof].size())
      held = std::max(held, wave_share_of_force(p.force[dof], p.step_s, hum.hertz) * rms_about_mean(p.force[dof]));
  return held > 0 && held * kOneOfThem > needed;
}

// What a motion channel's hum is weighed against where no other motion channel is: the most that a force has of it.
double most_of_forces(const Task& task, double hertz) {
  double most = 0;
  for (const Prepared& p : task.records)
    for (const Vec& force : p.force) most = std::max(most, wave_share_of_force(force, p.step_s, hertz));
  return most;
}

}  // namespace

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
  const std::vector<double> share = shares_of_signals(traces, hum);
  for (size_t i = 0; i < traces.size(); ++i) {
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
    const auto same = [&](const Cause& o) { return o.effect == c.effect && o.where == c.where; };
    if (std::any_of(d.causes.begin(), d.causes.end(), same)) return;
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

namespace {

bool is_hum(const Cause& c) { return c.effect == "mains_hum"; }

// Of the channel's signal; 0 where it is none of the records'.
double share_of_signal(const Task& task, const Cause& c) {
  const Prepared& p = task.records[0];
  const auto share = [&](const Vec& y) {
    const double rms = rms_about_mean(y);
    return rms > 0 && !c.parameters.empty() ? c.parameters[0].value / rms : 0;
  };
  for (const MotionTrace& t : p.traces)
    if (c.where == "channel " + t.channel) return share(t.y);
  for (size_t dof = 0; dof < p.force.size(); ++dof)
    if (c.where == "channel " + force_channel(task.system.rig, dof)) return share(p.force[dof]);
  return 0;
}

// The causes that `gone` holds for, with their numbers.
template <typename Gone>
void take_back(Diagnosis& d, Gone gone) {
  for (const Cause& c : d.causes)
    for (const diagnosis::Parameter& taken : c.parameters)
      if (gone(c))
        d.extended.parameters.erase(std::remove_if(d.extended.parameters.begin(), d.extended.parameters.end(),
                                                   [&](const diagnosis::Parameter& p) { return p.name == taken.name; }),
                                    d.extended.parameters.end());
  d.causes.erase(std::remove_if(d.causes.begin(), d.causes.end(), gone), d.causes.end());
}

// One channel's hum, where it is far more of its signal than any other's: what was left of it when it was taken out looks like
// another's. Empty: none is.
std::string worst_of_all(const Task& task, const Diagnosis& d) {
  double worst = 0, next = 0;
  std::string where;
  for (const Cause& c : d.causes) {
    const double share = is_hum(c) ? share_of_signal(task, c) : 0;
    next = std::max(next, std::min(share, worst));
    if (share > worst) worst = share, where = c.where;
  }
  return worst > kOneOfThem * next ? where : "";
}

}  // namespace

void say_shared_hum(const Task& task, const Choice& choice, Diagnosis& d) {
  const std::vector<MotionTrace>& traces = task.records[0].traces;
  const auto named = std::count_if(d.causes.begin(), d.causes.end(), is_hum);
  const auto rivals = std::count_if(d.ambiguous_with.begin(), d.ambiguous_with.end(),
                                    [](const NamedPlace& p) { return p.effect == "mains_hum"; });
  const bool alike = alike_in_all(traces, hum_seen(choice));
  const bool quiet = traces.size() == 1 && d.baseline_misfit < kAsLoudAsNoise;
  const auto channels = quiet ? named + rivals : named;  // the only one or the force, or both
  if (named == 0 || (channels < 2 && !alike)) return;
  const std::string worst = alike || quiet ? "" : worst_of_all(task, d);
  take_back(d, [&](const Cause& c) { return is_hum(c) && c.where != worst; });
  if (!worst.empty()) return;
  d.ambiguous_with.erase(std::remove_if(d.ambiguous_with.begin(), d.ambiguous_with.end(),
                                        [](const NamedPlace& p) { return p.effect == "mains_hum"; }),
                         d.ambiguous_with.end());
  const auto told = [](const std::string& text) { return text.rfind(kHumTold, 0) == 0; };
  if (std::none_of(d.advice.begin(), d.advice.end(), told))
    d.advice.push_back("mains hum lies on " + std::to_string(channels) +
                       " channels or more: it is the room's, and left out of the judgement");
  d.settle();
  if (!d.causes.empty()) return;
  d.baseline.parameters = d.extended.parameters;
  d.verdict = d.verdict == Verdict::kPartly ? Verdict::kUnknown : Verdict::kNone;
}

}  // namespace diagnosis::runs
