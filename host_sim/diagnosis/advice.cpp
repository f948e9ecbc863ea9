#include "advice.hpp"

#include <cmath>
#include <set>

#include "firmware/vocabulary/effect_table.hpp"

namespace diagnosis {
namespace {

// The experiment that sets an effect apart from those that look like it.
std::string experiment(const std::string& effect) {
  const firmware::EffectRow* row = firmware::find_effect(effect.c_str());
  return row == nullptr ? "" : row->experiment.text;
}

}  // namespace

std::vector<std::string> advice_for(const Diagnosis& d) {
  std::set<std::string> unique;
  std::vector<std::string> list;
  const auto say = [&](const std::string& text) {
    if (!text.empty() && unique.insert(text).second) list.push_back(text);
  };
  if (d.verdict == Verdict::kAmbiguous) {
    for (const Cause& c : d.causes) say(experiment(c.effect));
    for (const NamedPlace& p : d.ambiguous_with) say(experiment(p.effect));
  }
  if (d.verdict == Verdict::kUnknown && !d.unknown_trace.empty())
    say("the residual looks like " + d.unknown_trace + ", which is none of the named effects");
  if (d.noise_hides())
    say("noise hides what may be missing: measure the force with less noise, at a higher level or for longer");
  else if (d.verdict == Verdict::kUnknown || d.verdict == Verdict::kPartly)
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
