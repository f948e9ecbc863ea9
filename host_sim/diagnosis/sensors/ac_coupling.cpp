#include "ac_coupling.hpp"

#include <algorithm>
#include <cmath>

#include "fault_report.hpp"
#include "hal/rig_file/channel_entry.hpp"

namespace diagnosis {
namespace {

constexpr double kTrifle = 2e-4;       // of the channel's rms, as of a gain: nobody could put it right
constexpr double kCalibration = 0.01;  // of the channel's rms: sensors are not better calibrated
constexpr double kPaysUnseen = 0.7;    // of what was missed on unseen data, as of any cause

// A second channel of one DOF, without which nothing can be told.
bool any_pair(const host_sim::Record& record) {
  for (const host_sim::Channel& a : record.channels)
    for (const host_sim::Channel& b : record.channels)
      if (a.dof == b.dof && a.quantity < b.quantity && a.quantity != host_sim::Quantity::kForce) return true;
  return false;
}

// Of the same channel in further records: the mean, each weighted by what it knows.
void join(std::vector<SensorFault>& list, const SensorFault& fault) {
  for (SensorFault& known : list)
    if (same_fault(known, fault)) {
      const double a = 1 / (known.std * known.std), b = 1 / (fault.std * fault.std);
      known.value = (a * known.value + b * fault.value) / (a + b);
      known.std = 1 / std::sqrt(a + b), known.score += fault.score;
      return;
    }
  list.push_back(fault);
}

double share_taken(const SensorFault& fault, const host_sim::Record& record) {
  const auto channel = std::find_if(record.channels.begin(), record.channels.end(),
                                    [&](const host_sim::Channel& c) { return c.name == fault.channel; });
  if (channel == record.channels.end()) return 0;
  return host_sim::share_taken(channel->values, fault.value, record.sample_period_s);
}

}  // namespace

std::vector<SensorFault> ac_couplings(const Asked& asked) {
  std::vector<SensorFault> list;
  if (!any_pair(asked.training.front())) return list;
  for (const SensorFault& fault : motion_faults(asked))
    if (fault.kind == FaultKind::kAcCoupling) join(list, fault);
  list.erase(std::remove_if(list.begin(), list.end(),
                            [&](const SensorFault& f) {
                              return !(f.value > 0) || share_taken(f, asked.training.front()) < kTrifle;
                            }),
             list.end());
  return list;
}

std::vector<SensorFault> forces_coupled_alike(const std::vector<SensorFault>& found, const host_sim::Record& record) {
  double sum = 0, weight = 0;
  for (const SensorFault& f : found)
    if (f.quantity == 2) sum += f.value / (f.std * f.std), weight += 1 / (f.std * f.std);
  std::vector<SensorFault> list;
  if (weight == 0) return list;
  for (const host_sim::Channel& c : record.channels) {
    if (c.quantity != host_sim::Quantity::kForce) continue;
    SensorFault alike;
    alike.kind = FaultKind::kAcCoupling, alike.channel = c.name, alike.value = sum / weight;
    alike.std = std::sqrt(1 / weight);
    list.push_back(alike);
  }
  return list;
}

bool pays_unseen(const Diagnosis& with, const Diagnosis& without) {
  const auto worst = [](const Diagnosis& d) {
    const std::vector<double>& missed = d.baseline.holdout_nrmse_percent;
    return missed.empty() ? 0.0 : *std::max_element(missed.begin(), missed.end());
  };
  return worst(with) < kPaysUnseen * worst(without);
}

bool all_small(const std::vector<SensorFault>& found, const host_sim::Record& record) {
  return std::all_of(found.begin(), found.end(),
                     [&](const SensorFault& f) { return share_taken(f, record) < kCalibration; });
}

bool undoing_matters(const Diagnosis& undone, const Diagnosis& as_recorded) {
  const auto moved = [&](const Parameter& p) {
    const std::vector<Parameter>& others = undone.baseline.parameters;
    const auto other = std::find_if(others.begin(), others.end(), [&](const Parameter& o) { return o.name == p.name; });
    return p.estimated && (other == others.end() || std::abs(other->value - p.value) > kHalfOf95 * p.std);
  };
  const std::vector<Parameter>& numbers = as_recorded.baseline.parameters;
  return pays_unseen(undone, as_recorded) || std::any_of(numbers.begin(), numbers.end(), moved);
}

std::vector<host_sim::AcCoupling> couplings_of(const Diagnosis& d) {
  const size_t prefix = std::string("channel ").size();
  std::vector<host_sim::AcCoupling> list;
  for (const Cause& c : d.causes)
    if (c.effect == "ac_coupling") list.push_back({c.where.substr(prefix), c.parameters.at(0).value});
  return list;
}

void name_ac_couplings(const std::vector<SensorFault>& found, Diagnosis& d) {
  for (const SensorFault& fault : found) {
    d.causes.insert(d.causes.begin(), cause_of(fault));
    rig_file::entry_to_write(d.extended_rig, fault.channel).ac_coupling_Hz += fault.value;
  }
  if (d.verdict == Verdict::kNone) d.verdict = Verdict::kExplained;
  if (d.verdict == Verdict::kUnknown) d.verdict = Verdict::kPartly, d.more_remains = true;
}

}  // namespace diagnosis
