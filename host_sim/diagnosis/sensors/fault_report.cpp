#include "fault_report.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis {
namespace {

const char* word_of(FaultKind kind) {
  return kind == FaultKind::kDelay        ? "sensor_delay"
         : kind == FaultKind::kGain       ? "sensor_gain"
         : kind == FaultKind::kAcCoupling ? "ac_coupling"
                                          : "mains_hum";
}

// A hum has the unit of its channel.
std::string unit_of(const SensorFault& fault) {
  constexpr const char *kUnits[] = {"m", "m/s", "m/s^2"}, *kAngles[] = {"rad", "rad/s", "rad/s^2"};
  if (fault.kind == FaultKind::kAcCoupling) return "Hz";
  if (!is_hum(fault.kind)) return fault.kind == FaultKind::kDelay ? "s" : "1";
  return (fault.channel.find("_rad") != std::string::npos ? kAngles : kUnits)[fault.quantity];
}

}  // namespace

Cause cause_of(const SensorFault& fault) {
  Cause c;
  c.effect = word_of(fault.kind);
  c.where = "channel " + fault.channel;
  c.significance = fault.score, c.taken_out = true;
  const double value = is_hum(fault.kind) ? std::hypot(fault.value, fault.quadrature) : fault.value;
  c.parameters.push_back({c.effect + "[" + fault.channel + "]", value, unit_of(fault), fault.std, true});
  if (is_hum(fault.kind))
    c.parameters.push_back({"mains_frequency[" + fault.channel + "]", hum_Hz(fault.kind), "Hz", 0, false});
  return c;
}

NamedPlace named_place(const SensorFault& fault) { return {word_of(fault.kind), "channel " + fault.channel}; }

void report_faults(const std::vector<SensorCheck>& checks, Diagnosis& d) {
  for (const SensorCheck& check : checks)
    for (size_t i = 0; i < check.faults.size(); ++i) {
      if (check.faults[i].kind == FaultKind::kAcCoupling) continue;  // is named before (ac_coupling.hpp)
      const Cause cause = cause_of(check.faults[i]);
      const auto same = [&](const Cause& c) { return c.effect == cause.effect && c.where == cause.where; };
      if (std::any_of(d.causes.begin(), d.causes.end(), same)) continue;  // the same fault in a further record
      d.causes.push_back(cause);
      for (const SensorFault& rival : check.rivals[i]) d.ambiguous_with.push_back(named_place(rival));
    }
}

std::vector<DetectionLimit> fault_limits(const std::vector<SensorCheck>& checks) {
  std::vector<DetectionLimit> list;
  for (const SensorCheck& check : checks)
    for (const SensorFault& f : check.smallest) {
      const DetectionLimit limit{word_of(f.kind), "channel " + f.channel, f.value, unit_of(f), 0};
      // the two mains frequencies are one effect
      const auto known =
          std::find_if(list.begin(), list.end(), [&](const DetectionLimit& l) { return l.same_place(limit); });
      if (known == list.end())
        list.push_back(limit);
      else
        known->strength = std::min(known->strength, limit.strength);
    }
  return list;
}

}  // namespace diagnosis
