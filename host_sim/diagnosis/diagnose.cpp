#include "diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "naming.hpp"
#include "search.hpp"
#include "sensor_check.hpp"
#include "sharpen.hpp"

namespace diagnosis {

const char* verdict_word(Verdict v) {
  return v == Verdict::kNone ? "none" : v == Verdict::kExplained ? "explained" : v == Verdict::kAmbiguous ? "ambiguous" : "unknown";
}

Diagnosis diagnose(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                   const std::vector<host_sim::Record>&, const Options& options) {
  Diagnosis d;
  const System system = make_system(rig);
  std::vector<FusedRecord> records;
  for (const host_sim::Record& r : training) {
    records.push_back(read_record(rig, r, options.top_of_band));
    const SensorCheck check = check_sensors(records.back());
    for (size_t i = 0; i < check.faults.size(); ++i) {
      const SensorFault& fault = check.faults[i];
      Cause c;
      c.effect = fault.kind == FaultKind::kDelay ? "sensor_delay" : fault.kind == FaultKind::kGain ? "sensor_gain" : "mains_hum";
      c.where = "channel " + fault.channel;
      c.significance = fault.score;
      const bool hum = fault.kind == FaultKind::kHum50 || fault.kind == FaultKind::kHum60;
      c.parameters.push_back({c.effect + "[" + fault.channel + "]",
                              hum ? std::hypot(fault.value, fault.quadrature) : fault.value,
                              fault.kind == FaultKind::kDelay ? "s" : "1", fault.std, true});
      if (hum) c.parameters.push_back({"mains_frequency", fault.kind == FaultKind::kHum50 ? 50.0 : 60.0, "Hz", 0, false});
      d.causes.push_back(c);
      for (const SensorFault& rival : check.rivals[i])
        d.ambiguous_with.push_back({rival.kind == FaultKind::kDelay ? "sensor_delay" : rival.kind == FaultKind::kGain ? "sensor_gain" : "mains_hum",
                                    "channel " + rival.channel});
    }
    fuse(records.back());
  }
  for (int pass = 0; pass < 2; ++pass) {
    Rows first(system, records);
    std::vector<ActiveTerm> model = base_model(first);
    settle(first, model, 3);
    sharpen(records, system, model);
  }
  Rows rows(system, records);
  const CandidateBank bank(rows);
  const SearchResult found = search(rows, bank);
  d.baseline_misfit = found.base_fit.ratio();
  d.extended_misfit = found.fit.ratio();
  for (size_t i = 0; i < found.added.size(); ++i) {
    const Term& t = found.added[i].candidate.term();
    Cause c;
    c.effect = word_of(t.kind);
    c.where = place_of(system, t, records[0]);
    c.significance = found.added[i].score;
    for (const ActiveTerm& active : found.model)
      if (active.added && active.column.term.same_place(t)) c.parameters = parameters_of_term(system, active);
    d.causes.push_back(c);
    for (const Found& r : found.rivals[i])
      d.ambiguous_with.push_back({word_of(r.candidate.term().kind), place_of(system, r.candidate.term(), records[0])});
  }
  d.baseline.parameters = parameters_of(system, found.base);
  d.extended.parameters = parameters_of(system, found.model);
  d.extended_rig = extended_rig(system, found.model);
  const double drop = (found.base_fit.chi2 - found.fit.chi2) / found.fit.dof;
  const bool noise_only = found.fit.ratio() - 1 < 0.25 + 0.003 * drop;
  d.verdict = !noise_only ? Verdict::kUnknown
              : d.causes.empty() ? Verdict::kNone
              : d.ambiguous_with.empty() ? Verdict::kExplained : Verdict::kAmbiguous;
  return d;
}

}  // namespace diagnosis
