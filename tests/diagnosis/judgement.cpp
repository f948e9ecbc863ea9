#include "judgement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hidden {
namespace {

using diagnosis::Verdict;

bool among(const Hidden& truth, const diagnosis::Diagnosis& d, bool rivals_too) {
  for (const diagnosis::Cause& c : d.causes)
    if (c.effect == truth.effect && c.where == truth.where) return true;
  if (rivals_too)
    for (const diagnosis::NamedPlace& p : d.ambiguous_with)
      if (p.effect == truth.effect && p.where == truth.where) return true;
  return false;
}

}  // namespace

// A force that comes in steps is told as such, and is no part of what is hidden.
diagnosis::Diagnosis answer_to(const Draw& draw) {
  diagnosis::Diagnosis d = diagnosis::diagnose(draw.rig, {draw.record}, {});
  const auto held = [](const diagnosis::Cause& c) { return c.effect == "force_hold"; };
  const auto from = std::remove_if(d.causes.begin(), d.causes.end(), held);
  if (from == d.causes.end() || d.force_between_samples != "steps") return d;
  d.causes.erase(from, d.causes.end());
  if (d.causes.empty() && d.verdict == Verdict::kExplained) d.verdict = Verdict::kNone;
  return d;
}

Outcome judge(const Draw& draw, const diagnosis::Diagnosis& d) {
  if (draw.truth.empty()) return d.verdict == Verdict::kNone ? Outcome::kExact : Outcome::kWrong;
  if (draw.truth[0].effect == "outside") return d.verdict == Verdict::kUnknown ? Outcome::kExact : Outcome::kWrong;
  if (d.causes.size() != draw.truth.size()) return Outcome::kWrong;
  bool named = d.verdict == Verdict::kExplained, listed = d.verdict == Verdict::kAmbiguous;
  for (const Hidden& h : draw.truth) {
    named = named && among(h, d, false);
    listed = listed && among(h, d, true);
  }
  return named ? Outcome::kExact : listed ? Outcome::kSet : Outcome::kWrong;
}

std::string told(const Draw& draw, const diagnosis::Diagnosis& d) {
  char text[256];
  std::string line = "hidden:";
  for (size_t i = 0; i < draw.truth.size(); ++i) {
    const Hidden& h = draw.truth[i];
    const std::string name = h.effect == "outside" ? draw.true_rig.effects[i].kind : h.effect;
    std::snprintf(text, sizeof text, " %s on %s (rho %.3f)", name.c_str(), h.where.c_str(), h.rho);
    line += text;
  }
  std::snprintf(text, sizeof text, " nothing%s; misfit %.3f to %.3f; answer: ", "", d.baseline_misfit,
                d.extended_misfit);
  line += draw.truth.empty() ? text : std::string(text).substr(8);
  line += diagnosis::verdict_word(d.verdict);
  for (const diagnosis::Cause& c : d.causes) line += " " + c.effect + " on " + c.where;
  for (const diagnosis::NamedPlace& p : d.ambiguous_with) line += " | or " + p.effect + " on " + p.where;
  for (const diagnosis::Cause& c : d.rejected) line += "; rejected: " + c.effect + " on " + c.where;
  for (const Hidden& h : draw.truth)
    for (const diagnosis::DetectionLimit& l : d.minimum_detectable)
      if (l.effect == h.effect && l.where == h.where && std::isinf(l.strength))
        line += "; said not to show in these data";
  if (!d.unknown_trace.empty()) line += "; trace: " + d.unknown_trace;
  return line;
}

}  // namespace hidden
