#include "trifles.hpp"

#include <algorithm>
#include <cmath>

#include "../trial/merit.hpp"
#include "materiality.hpp"

namespace diagnosis::runs {
namespace {

// What the cause's first number is an error of; 0: of nothing that is given.
double given(const System& system, const Cause& c) {
  if (c.effect == "sensor_gain") return 1;
  if (c.effect == "mass_error")
    for (size_t i = 0; i < system.dofs(); ++i)
      if (c.where == "dof " + std::to_string(i + 1)) return system.rig.dofs[i].mass_kg.value;
  if (c.effect == "stiffness_error")
    for (size_t l = 0; l < system.known_links; ++l)
      if (c.where == "link " + rig_file::link_label(system.links[l])) return system.links[l].stiffness_N_m.value;
  return 0;
}

// Share of a motion channel's power that is noise; 0 for others.
double noise_of_channel(const Task& task, const std::string& where) {
  for (const Prepared& p : task.records)
    for (const MotionTrace& t : p.traces)
      if (where == "channel " + t.channel) {
        const double power = (t.y.array() - t.y.mean()).square().mean();
        return power > 0 ? std::pow(noise_level(t.y), 2) / power : 0;
      }
  return 0;
}

// What the cause's first number has to exceed.
double trifle_of(const Task& task, const Cause& c) {
  const double least = kTrifle * std::abs(given(task.system, c));
  return c.effect == "sensor_gain" ? std::max(least, kAttenuation * noise_of_channel(task, c.where)) : least;
}

// Without one of its causes: whatever was said beside it in its place goes too.
void take_back(Diagnosis& d, size_t i) {
  const std::string where = d.causes[i].where;
  d.causes.erase(d.causes.begin() + static_cast<std::ptrdiff_t>(i));
  d.ambiguous_with.erase(std::remove_if(d.ambiguous_with.begin(), d.ambiguous_with.end(),
                                        [&](const NamedPlace& p) { return p.where == where; }),
                         d.ambiguous_with.end());
}

bool may_be_nought(const Cause& c) {
  return !c.parameters.empty() && c.parameters[0].std > 0 &&
         std::abs(c.parameters[0].value) <= kHalfOf95 * c.parameters[0].std;
}

}  // namespace

void drop_undetermined(Diagnosis& d, bool base_follows) {
  const Verdict before = d.verdict;
  const bool any = !d.causes.empty();
  for (size_t i = 0; i < d.causes.size();) {
    const Cause& c = d.causes[i];
    const auto same = [&](const Cause& o) { return o.effect == c.effect && o.where == c.where; };
    const auto end = d.causes.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(d.causes.begin(), end, same))
      d.causes.erase(end);  // said already: what drifts within records may drift across them too
    else if (may_be_nought(c))
      take_back(d, i);
    else
      ++i;
  }
  // What had only noise left is right as far as these data can tell, where the rig as given does no worse; else something is missing.
  if (any && d.causes.empty()) {
    const bool no_gain = std::all_of(d.gain.begin(), d.gain.end(), [](double gain) { return gain < kLeastGain; });
    const bool as_good = d.leaves_noise_alone() || (base_follows && no_gain);
    d.ambiguous_with.clear();
    d.verdict = before == Verdict::kExplained && as_good ? Verdict::kNone : Verdict::kUnknown;
  }
  d.settle();
}

void drop_trifles(const Task& task, Diagnosis& d) {
  if (d.verdict == Verdict::kUnknown || d.causes.empty()) return;
  for (size_t i = 0; i < d.causes.size();) {
    const Cause& c = d.causes[i];
    const bool trifle = !c.parameters.empty() && std::abs(c.parameters[0].value) < trifle_of(task, c);
    if (!trifle) {
      ++i;
      continue;
    }
    take_back(d, i);
  }
  for (const Cause& c : d.causes)  // what is named is no alternative to itself
    d.ambiguous_with.erase(
        std::remove_if(d.ambiguous_with.begin(), d.ambiguous_with.end(),
                       [&](const NamedPlace& p) { return p.effect == c.effect && p.where == c.where; }),
        d.ambiguous_with.end());
  if (d.causes.empty()) d.ambiguous_with.clear();
  d.settle();
  if (d.causes.empty() && d.verdict == Verdict::kExplained) d.verdict = Verdict::kNone;
  if (d.causes.empty() && d.verdict != Verdict::kNone) d.verdict = Verdict::kUnknown;  // it was not all that is missing
}

}  // namespace diagnosis::runs
