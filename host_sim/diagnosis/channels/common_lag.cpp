#include "common_lag.hpp"

#include <algorithm>
#include <cstdio>

namespace diagnosis::runs {
namespace {

// Of the motion's highest frequency, in periods: the group delay of a fourth-order Butterworth filter below its corner is
// 2.61 / (2 pi corner), and a lower corner would have taken that motion away.
constexpr double kLongestLag = 0.42;

bool lag_of_motion(const Cause& c, double longest_s) {
  const bool of_force = c.where.rfind("channel force", 0) == 0 || c.where.rfind("channel torque", 0) == 0;
  return c.effect == "sensor_delay" && of_force && !c.parameters.empty() && c.parameters[0].value < 0 &&
         -c.parameters[0].value < longest_s;
}

}  // namespace

double say_common_lag(const Task& task, Diagnosis& d) {
  double top_Hz = 0;
  for (const Prepared& p : task.records) top_Hz = std::max(top_Hz, p.top_Hz);
  if (task.records[0].traces.size() < 2 || !(top_Hz > 0)) return 0;  // of one channel alone it is the channel's
  double lag_s = 0;
  for (const Cause& c : d.causes)
    if (lag_of_motion(c, kLongestLag / top_Hz)) lag_s = std::max(lag_s, -c.parameters[0].value);
  if (lag_s == 0) return 0;
  d.causes.erase(std::remove_if(d.causes.begin(), d.causes.end(),
                                [&](const Cause& c) { return lag_of_motion(c, kLongestLag / top_Hz); }),
                 d.causes.end());
  char text[160];
  std::snprintf(text, sizeof text,
                "all motion channels lag the force by %.3g ms, as behind an anti-alias filter on them alone: taken out "
                "before the rig is judged",
                1e3 * lag_s);
  d.advice.push_back(text);
  if (!d.causes.empty()) return lag_s;
  d.ambiguous_with.clear();
  d.baseline = d.extended;
  d.verdict = d.verdict == Verdict::kPartly ? Verdict::kUnknown : Verdict::kNone;
  return lag_s;
}

}  // namespace diagnosis::runs
