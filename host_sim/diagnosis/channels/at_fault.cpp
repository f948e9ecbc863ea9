#include "at_fault.hpp"

#include <algorithm>

#include "../fit/error_rates.hpp"
#include "../sensors/fault_report.hpp"
#include "../sensors/lone_channel.hpp"

namespace diagnosis {
namespace {

// Of each DOF's channels the one whose fault explains most, beyond chance: beside one that is bent the others look off too. A hum that
// lies on several is the room's, and none's fault.
std::vector<SensorFault> worst_faults(const Asked& asked) {
  std::vector<SensorFault> worst;
  const std::vector<SensorFault> faults = motion_faults(asked);
  const auto hums = std::count_if(faults.begin(), faults.end(), [](const SensorFault& f) { return is_hum(f.kind); });
  for (const SensorFault& fault : faults) {
    if (fault.score < runs::kNamed * runs::kNamed || (is_hum(fault.kind) && hums > 1)) continue;
    const auto known =
        std::find_if(worst.begin(), worst.end(), [&](const SensorFault& w) { return w.dof == fault.dof; });
    if (known == worst.end())
      worst.push_back(fault);
    else if (fault.score > known->score)
      *known = fault;
  }
  return worst;
}

// Whether every one of the channels leaves another of its DOF's motion behind.
bool all_spared(const host_sim::Record& record, const std::vector<std::string>& names) {
  const std::vector<host_sim::Record> rest = without_channels({record}, names);
  return std::all_of(record.channels.begin(), record.channels.end(), [&](const host_sim::Channel& c) {
    if (std::find(names.begin(), names.end(), c.name) == names.end()) return true;
    return std::any_of(rest[0].channels.begin(), rest[0].channels.end(), [&](const host_sim::Channel& other) {
      return other.dof == c.dof && other.quantity != host_sim::Quantity::kForce;
    });
  });
}

// Nothing, or nothing but channels.
bool blames_channels_alone(const Diagnosis& d) {
  return std::all_of(d.causes.begin(), d.causes.end(), [](const Cause& c) { return c.where.find("channel ") == 0; });
}

bool is_better(const Diagnosis& d) {
  return d.verdict != Verdict::kUnknown && d.verdict != Verdict::kPartly && !d.more_remains;
}

}  // namespace

Diagnosis judged_without_those_at_fault(const Asked& asked, Diagnosis (*judge)(const Asked&)) {
  const Diagnosis of_all = judge(asked);
  if (is_better(of_all) || !blames_channels_alone(of_all)) return of_all;
  const std::vector<SensorFault> faults = worst_faults(asked);
  std::vector<std::string> names;
  for (const SensorFault& fault : faults) names.push_back(fault.channel);
  if (names.empty() || !all_spared(asked.training.front(), names)) return of_all;
  const std::vector<host_sim::Record> training = without_channels(asked.training, names),
                                      holdout = without_channels(asked.holdout, names);
  Diagnosis d = judge({asked.rig, training, holdout, asked.options, asked.ground_known});
  if (!is_better(d)) return of_all;
  for (const SensorFault& fault : faults) {
    Cause cause = cause_of(fault);
    cause.taken_out = true;
    d.causes.insert(d.causes.begin(), cause);
  }
  if (d.verdict == Verdict::kNone) d.verdict = Verdict::kExplained;
  d.channels_left_out = names;
  return d;
}

}  // namespace diagnosis
