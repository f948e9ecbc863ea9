#include "advice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "firmware/vocabulary/effect_table.hpp"

namespace diagnosis {
namespace {

// The experiment that sets an effect apart from those that look like it.
std::string experiment(const std::string& effect) {
  const firmware::EffectRow* row = firmware::find_effect(effect.c_str());
  return row == nullptr ? "" : row->experiment.text;
}

constexpr double kOddNumber = 1.5;    // times: beyond it nobody would call it a tolerance
constexpr double kPowerOfTen = 0.05;  // near one: a unit or a decimal point

// "mass 2 is 13 kg in the rig file, 1.302 kg by the recording: ..." Empty where it is about the same.
std::string odd_number(const std::string& what, double corrected, double error, const std::string& unit) {
  const double given = corrected - error;
  if (given == 0 || (corrected / given < kOddNumber && corrected / given > 1 / kOddNumber)) return "";
  const double decades = std::log10(std::abs(corrected / given)), whole = std::round(decades);
  const bool slip = corrected / given > 0 && whole != 0 && std::abs(decades - whole) < kPowerOfTen;
  char text[200];
  std::snprintf(text, sizeof text, "%s is %.4g %s in the rig file, %.4g %s by the recording%s", what.c_str(), given,
                unit.c_str(), corrected, unit.c_str(), slip ? ": a unit or a decimal point?" : "");
  return text;
}

// Of a mass or a spring that the rig file has wrong by much: both numbers.
std::string odd_number(const Cause& c, const rig_file::RigModel& corrected) {
  if (c.parameters.empty()) return "";
  const Parameter& p = c.parameters[0];
  for (size_t i = 0; c.effect == "mass_error" && i < corrected.dofs.size(); ++i)
    if (const std::string dof = std::to_string(i + 1); c.where == "dof " + dof)
      return odd_number("mass " + dof, corrected.dofs[i].mass_kg.value, p.value, p.unit);
  for (const rig_file::Link& l : corrected.links)
    if (const std::string label = rig_file::link_label(l); c.effect == "stiffness_error" && c.where == "link " + label)
      return odd_number("spring " + label, l.stiffness_N_m.value, p.value, p.unit);
  return "";
}

// What a rig file states, or what was found for it.
double size_of(const rig_file::Coefficient& c, const std::string& name, const Diagnosis& d) {
  if (!c.estimate) return c.value;
  for (const Parameter& p : d.extended.parameters)
    if (p.name == name) return p.value;
  return 0;
}

// A spring whose displacement reads z too much lacks stiffness times -z, a constant force; a pendulum that hangs is a spring of its gravity
// torque. Empty where the cause is another, or there is no spring.
std::string zero_that_is_off(const Cause& c, const Diagnosis& d) {
  if (c.effect != "force_offset" || c.parameters.empty()) return "";
  for (const rig_file::Link& l : d.extended_rig.links) {
    const std::string label = rig_file::link_label(l);
    const double spring = size_of(l.stiffness_N_m, "stiffness[" + label + "]", d) +
                          size_of(l.gravity_torque_N_m, "gravity_torque[" + label + "]", d);
    if (c.where != "link " + label || !(spring > 0)) continue;
    const double too_much = -c.parameters[0].value / spring, off = std::abs(too_much);
    char text[240];
    std::snprintf(
        text, sizeof text,
        "displacement over link %s that reads %.3g %s too %s looks the same as its constant force: see what the "
        "channel reads with the rig at rest and unloaded",
        label.c_str(), off, c.parameters[0].unit == "N m" ? "rad" : "m", too_much > 0 ? "much" : "little");
    return text;
  }
  return "";
}

}  // namespace

std::vector<std::string> advice_for(const Diagnosis& d) {
  std::set<std::string> unique;
  std::vector<std::string> list;
  const auto say = [&](const std::string& text) {
    if (!text.empty() && unique.insert(text).second) list.push_back(text);
  };
  for (const Cause& c : d.causes) say(odd_number(c, d.extended_rig)), say(zero_that_is_off(c, d));
  if (d.verdict == Verdict::kAmbiguous) {
    for (const Cause& c : d.causes) say(experiment(c.effect));
    for (const NamedPlace& p : d.ambiguous_with) say(experiment(p.effect));
  }
  if (d.verdict == Verdict::kUnknown && !d.unknown_trace.empty())
    say("the residual looks like " + d.unknown_trace + ", which is none of the named effects");
  const std::vector<Parameter>& numbers = d.baseline.parameters;
  const bool no_number = !numbers.empty() &&
                         std::all_of(numbers.begin(), numbers.end(), [](const Parameter& p) { return p.undetermined; });
  if (d.noise_hides()) {
    if (!no_number)
      say(d.driven
              ? "noise hides what may be missing: measure the force with less noise, at a higher level or for longer"
              : "noise hides what may be missing: let it go from farther, or measure with less noise");
  } else if (d.verdict == Verdict::kUnknown || d.verdict == Verdict::kPartly) {
    say("a force remains that no effect of the vocabulary explains: look at the residual against elongation, rate and "
        "time, "
        "and record with one suspected part removed or held");
    if (d.verdict == Verdict::kUnknown && d.causes.empty() && !d.possible.empty())
      say("these records do not bear out " + d.possible.front().place.effect + " on " + d.possible.front().place.where +
          ", which comes nearest: " + experiment(d.possible.front().place.effect));
  }
  if (d.determines_nothing) return list;
  if (d.verdict == Verdict::kNone && !d.unknown_trace.empty())
    say("what is left looks faintly like " + d.unknown_trace +
        ", too little to bend a number: record at a higher level");
  else if (d.verdict == Verdict::kNone)
    say(std::string(d.leaves_noise_alone() ? "nothing beyond measurement noise: " : "") +
        (d.minimum_detectable.empty() ? "to see weaker effects, " : "to see weaker effects than those listed, ") +
        "record longer or at a higher level");
  bool offset = false, fault = false;  // that no strength would show
  for (const DetectionLimit& l : d.minimum_detectable) {
    offset = offset || (std::isinf(l.strength) && l.effect == "force_offset");
    fault = fault || (std::isinf(l.strength) && l.where.rfind("channel ", 0) == 0);
  }
  if (d.verdict == Verdict::kNone && offset)
    say("a constant force that springs hold shows in a displacement only: measure that of every DOF");
  if (d.verdict == Verdict::kNone && fault)
    say("a sensor's fault shows against a second channel of its DOF only: add one");
  if (!d.rejected.empty() && d.causes.empty())
    say("a term that fits better but simulates worse was rejected: record more data at the level where it should act");
  return list;
}

}  // namespace diagnosis
