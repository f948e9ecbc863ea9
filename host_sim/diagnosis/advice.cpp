#include "advice.hpp"

#include <cmath>
#include <set>

namespace diagnosis {
namespace {

struct Test {
  const char* effect;
  const char* advice;
};
// The experiment that sets an effect apart from those that look like it.
constexpr Test kTests[] = {
    {"cubic_stiffness",
     "repeat at half and at double the level: a cubic spring grows smoothly, an end stop sets in at its gap"},
    {"end_stop", "repeat below the suspected gap: an end stop vanishes there, a hardening spring does not"},
    {"quadratic_damping",
     "repeat at two or three levels: quadratic, cubic and Stribeck damping grow with different powers of the rate"},
    {"cubic_damping",
     "repeat at two or three levels: quadratic, cubic and Stribeck damping grow with different powers of the rate"},
    {"stribeck", "add a slow sweep at low level: Stribeck friction falls with the rate only where the rate is small"},
    {"presliding_hysteresis", "add a quasi-static cycle smaller than the presliding length: it shows the loop alone"},
    {"mass_error",
     "add excitation above the present band: a hidden resonance turns its phase there, a wrong mass does not"},
    {"unmodelled_resonance",
     "add excitation above the present band: a hidden resonance turns its phase there, a wrong mass does not"},
    {"force_offset",
     "repeat with the rig turned or the static load removed: a constant force changes, a friction that differs with "
     "direction does not"},
    {"asymmetric_viscous",
     "repeat at two levels: a damping that differs with direction grows with the level, a constant force does not"},
    {"stiffness_error", "add a static load test of the link: it gives the stiffness alone"},
    {"backlash", "repeat at a lower level: the share of a backlash grows as the motion shrinks"},
    {"sensor_delay", "feed one common signal to all channels: it shows their delays and gains without the rig"},
    {"sensor_gain", "feed one common signal to all channels: it shows their delays and gains without the rig"},
    {"mains_hum", "record with the rig at rest: hum remains"},
    {"missing_coulomb", "add a low level, where dry friction outweighs viscous damping"},
    {"missing_viscous", "add a high level, where viscous damping outweighs dry friction"},
};

}  // namespace

std::vector<std::string> advice_for(const Diagnosis& d) {
  std::set<std::string> unique;
  std::vector<std::string> list;
  const auto say = [&](const std::string& text) {
    if (unique.insert(text).second) list.push_back(text);
  };
  if (d.verdict == Verdict::kAmbiguous) {
    for (const Cause& c : d.causes)
      for (const Test& t : kTests)
        if (c.effect == t.effect) say(t.advice);
    for (const NamedPlace& p : d.ambiguous_with)
      for (const Test& t : kTests)
        if (p.effect == t.effect) say(t.advice);
  }
  if (d.verdict == Verdict::kUnknown && !d.unknown_trace.empty())
    say("the residual looks like " + d.unknown_trace + ", which is none of the named effects");
  if (d.verdict == Verdict::kUnknown)
    say("a force remains that no effect of the vocabulary explains: look at the residual against elongation, rate and "
        "time, "
        "and record with one suspected part removed or held");
  if (d.verdict == Verdict::kNone)
    say("nothing beyond measurement noise: to see weaker effects than those listed, record longer or at a higher "
        "level");
  bool offset = false, fault = false;  // that no strength would show
  for (const DetectionLimit& l : d.minimum_detectable) {
    offset = offset || (std::isinf(l.strength) && l.effect == "force_offset");
    fault = fault || (std::isinf(l.strength) && l.where.rfind("channel ", 0) == 0);
  }
  if (d.verdict == Verdict::kNone && offset)
    say("a constant force shows in a displacement only: measure that of every DOF");
  if (d.verdict == Verdict::kNone && fault)
    say("a sensor's fault shows against a second channel of its DOF only: add one");
  if (!d.rejected.empty())
    say("a term that fits better but simulates worse was rejected: record more data at the level where it should act");
  return list;
}

}  // namespace diagnosis
