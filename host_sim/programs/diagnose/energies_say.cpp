#include "host_sim/programs/diagnose/energies_say.hpp"

#include <algorithm>
#include <stdexcept>

#include "hal/rig_file/compile_rig.hpp"
#include "host_sim/diagnosis/residual/most_noise.hpp"
#include "host_sim/programs/estimate/prepared_estimation.hpp"

namespace host_sim {
namespace {

using diagnosis::Diagnosis;
using diagnosis::Verdict;
using firmware::EstimateStatus;

// A fault of a channel that the extended rig file does not state: a gain, a hum, a hold. What is late or behind a high-pass it does.
bool unstated(const diagnosis::Cause& c) {
  if (c.where.rfind("channel ", 0) != 0) return false;
  return c.parameters.empty() || (c.effect != "sensor_delay" && c.effect != "ac_coupling");
}

bool can_be_asked(const Diagnosis& found) {
  const bool content = found.verdict == Verdict::kNone || found.verdict == Verdict::kExplained;
  return content && found.extended_misfit > diagnosis::runs::kBeyondNoise && !found.extended.parameters.empty() &&
         std::none_of(found.causes.begin(), found.causes.end(), unstated) &&
         rig_file::simulator_only_effects(found.extended_rig).empty();
}

EstimateResult energies_of(const std::vector<Record>& records, const Diagnosis& found) {
  rig_file::RigModel rig = found.extended_rig;
  SharedRecords shared(records);
  EstimationOptions options;
  options.frames = false;
  std::vector<std::string> notes;
  return estimate_prepared(rig, shared, options, notes).result;
}

bool mark(const std::string& name, std::vector<diagnosis::Parameter>& parameters) {
  for (diagnosis::Parameter& p : parameters)
    if (p.name == name) return p.may_be_bent = true;
  return false;
}

}  // namespace

void ask_energies(const std::vector<Record>& records, Diagnosis& found) {
  if (!can_be_asked(found)) return;
  EstimateResult energies;
  try {
    energies = energies_of(records, found);
  } catch (const std::runtime_error&) {  // too short, or more records than it takes: nothing is said
    return;
  }
  bool any = false;
  for (const ParameterResult& p : energies.parameters) {
    if (p.status != EstimateStatus::kModelSuspect && p.status != EstimateStatus::kBiasSuspect) continue;
    any = mark(p.info.name, found.extended.parameters) || any;
    if (found.causes.empty()) mark(p.info.name, found.baseline.parameters);
  }
  if (!any) return;
  found.more_remains = true;
  if (found.verdict == Verdict::kExplained) found.verdict = Verdict::kPartly;
}

}  // namespace host_sim
