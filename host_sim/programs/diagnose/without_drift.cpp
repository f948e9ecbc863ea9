#include "host_sim/programs/diagnose/without_drift.hpp"

#include "host_sim/programs/shared/slow_drift.hpp"

namespace host_sim {
namespace {

using diagnosis::Diagnosis;
using diagnosis::Verdict;

constexpr double kMuchLess = 0.5;  // of what a free run of unseen data misses

}  // namespace

std::string diagnose_without_drift(const rig_file::RigModel& rig, std::vector<Record>& training,
                                   std::vector<Record>& unseen, Diagnosis& found) {
  if (found.verdict == Verdict::kNone || found.verdict == Verdict::kExplained) return "";
  const Drift drift = drift_of(DriftOf::kDisplacements, rig, training);
  if (drift.end_Hz == 0.0) return "";
  std::vector<Record> fitted = training, others = unseen;
  take_off(DriftOf::kDisplacements, drift, fitted), take_off(DriftOf::kDisplacements, drift, others);
  Diagnosis d = diagnosis::diagnose(rig, fitted, others);
  if (!d.cannot_describe.empty() || d.extended.most_missed_percent() > kMuchLess * found.extended.most_missed_percent())
    return "";
  found = d, training = fitted, unseen = others;
  return said_of(drift);
}

}  // namespace host_sim
