#include <algorithm>

#include "../residual/lines.hpp"
#include "../terms/naming.hpp"
#include "hum.hpp"

namespace diagnosis::runs {
namespace {

// Every motion channel has as much of it. What a force answers to, or is said to, falls off from mass to mass, and from one
// quantity to the next.
bool alike_in_all(const std::vector<MotionTrace>& traces, const std::vector<Hum>& hum) {
  if (traces.size() < 2 || hum.size() != traces.size()) return false;
  const std::vector<double> shares = shares_of_signals(traces, hum);
  const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
  return *least > 0 && *most <= kOneOfThem * *least;
}

// Of the only motion channel: beside it no other cause counts, however much that one leaves of the rig as given.
bool quieter_than_noise(const Choice& choice) {
  const std::vector<Hum>& hum = hum_seen(choice);
  const Vec& noise = choice.final_left.noise;
  return hum.size() == 1 && noise.size() == 1 && 0.5 * hum[0].amplitude * hum[0].amplitude < noise[0];
}

constexpr auto is_hum = [](const auto& cause_or_rival) { return cause_or_rival.effect == "mains_hum"; };

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
  const auto rivals = std::count_if(d.ambiguous_with.begin(), d.ambiguous_with.end(), is_hum);
  const bool alike = alike_in_all(traces, hum_seen(choice));
  const bool quiet = traces.size() == 1 && quieter_than_noise(choice);
  const auto channels = quiet ? named + rivals : named;  // the only one or the force, or both
  if (named == 0 || (channels < 2 && !alike)) return;
  const std::string worst = alike || quiet ? "" : worst_of_all(task, d);
  take_back(d, [&](const Cause& c) { return is_hum(c) && c.where != worst; });
  if (!worst.empty()) return;
  d.ambiguous_with.erase(std::remove_if(d.ambiguous_with.begin(), d.ambiguous_with.end(), is_hum),
                         d.ambiguous_with.end());
  const size_t lies_on = alike ? traces.size() : static_cast<size_t>(channels);
  const auto told = [](const std::string& text) { return text.rfind(kHumTold, 0) == 0; };
  if (std::none_of(d.advice.begin(), d.advice.end(), told))
    d.advice.push_back("mains hum lies on " + std::to_string(lies_on) +
                       " channels or more: it is the room's, and left out of the judgement");
  d.settle();
  if (!d.causes.empty()) return;
  d.baseline.parameters = d.extended.parameters;
  d.verdict = d.verdict == Verdict::kPartly ? Verdict::kUnknown : Verdict::kNone;
}

}  // namespace diagnosis::runs
