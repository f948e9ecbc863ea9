#include "rows_say.hpp"

#include <algorithm>
#include <memory>

#include "../sensors/fault_report.hpp"
#include "../sensors/trials.hpp"
#include "../terms/naming.hpp"
#include "bench.hpp"
#include "limits.hpp"
#include "ranking.hpp"
#include "remainder.hpp"
#include "stretches.hpp"

namespace diagnosis {
namespace {

void report_terms(const System& system, const Rows& rows, const SearchResult& found, Diagnosis& d) {
  const double excess = std::max(1.0, found.base_fit.chi2 - found.fit.dof);
  for (size_t i = 0; i < found.added.size(); ++i) {
    const Term& t = found.added[i].candidate.term();
    Cause c;
    c.effect = word_of(t.kind);
    c.where = place_of(system, t, rows.records()[0]);
    c.significance = found.added[i].score;
    c.explains_percent = std::clamp(100 * found.added[i].gain.chi2 / excess, 0.0, 100.0);
    for (const ActiveTerm& active : found.model)
      if (active.added && active.term.same_place(t)) c.parameters = parameters_of_term(system, found.model, active);
    for (const Found& r : found.rivals[i]) {
      const Term& other = r.candidate.term();
      c.rivals.push_back({word_of(other.kind), place_of(system, other, rows.records()[0])});
    }
    d.ambiguous_with.insert(d.ambiguous_with.end(), c.rivals.begin(), c.rivals.end());
    d.causes.push_back(c);
  }
}

// How forces act between their samples; steps are an effect of the vocabulary, taken out before the rig is judged.
void report_holds(const rig_file::RigModel& rig, const std::vector<FusedRecord>& records, Diagnosis& d) {
  for (const FusedRecord& f : records) {
    if (f.hold != Hold::kSmooth) d.force_between_samples = f.hold == Hold::kLinear ? "linear" : "steps";
    for (size_t dof : f.held) {
      Cause c;
      c.effect = "force_hold", c.where = "channel " + force_channel(rig, dof), c.taken_out = true;
      if (!d.names(c.effect, c.where)) d.causes.push_back(c);
    }
  }
}

void also_ambiguous(const std::vector<NamedPlace>& rivals, Diagnosis& d) {
  d.ambiguous_with.insert(d.ambiguous_with.end(), rivals.begin(), rivals.end());
}

}  // namespace

RowsSay ask_rows(const System& system, const Asked& asked) {
  RowsSay say;
  Diagnosis& d = say.d;
  std::vector<SensorCheck> checks;
  auto owner = std::make_unique<Bench>(
      Bench{system, ready(asked.rig, stretches(asked.rig, asked.training), asked.options, &checks), {}});
  report_faults(checks, d);
  for (const SensorCheck& check : checks) say.faults.insert(say.faults.end(), check.faults.begin(), check.faults.end());
  owner->lay_out_sharpened();
  SensorCheck alone;
  SearchResult found = search_plain_first(owner, alone);
  try_holds(owner, found);
  const std::vector<NamedPlace> as_well = try_sole_channels(owner, found, alone);
  report_faults({alone}, d);
  report_holds(asked.rig, owner->records, d);
  Bench& bench = *owner;
  d.baseline_misfit = found.base_fit.ratio(), d.extended_misfit = found.fit.ratio();
  say.left = remainder_of(*bench.rows, *bench.bank, found);
  d.unknown_trace = say.left.trace;
  if (!say.left.noise_only) return say;
  say.faults.insert(say.faults.end(), alone.faults.begin(), alone.faults.end());
  Rows& rows = *bench.rows;
  report_terms(system, rows, found, d);
  for (const ActiveTerm& a : found.model) say.model.push_back({a.term, a.value});
  for (const Found& f : found.added) say.terms.push_back(f.candidate.term()), say.values.push_back(f.gain.coefficient);
  if (!found.added.empty()) also_ambiguous(as_well, d), also_ambiguous(equivalents(bench, found), d);
  d.ranked = ranking(system, rows, *bench.bank, found, 12);
  d.baseline.parameters = parameters_of(system, found.base);
  d.extended.parameters = parameters_of(system, found.model);
  d.extended_rig = extended_rig(system, found.model);
  state_delays(d.causes, d.extended_rig);
  d.minimum_detectable = detection_limits(rows, *bench.bank, found.model, found.fit);
  checks.push_back({{}, {}, smallest_of_sole_channels(bench, found)});
  for (const DetectionLimit& limit : fault_limits(checks)) d.minimum_detectable.push_back(limit);
  d.verdict = d.causes.empty() ? Verdict::kNone : d.ambiguous_with.empty() ? Verdict::kExplained : Verdict::kAmbiguous;
  return say;
}

std::vector<SensorFault> motion_faults(const Asked& asked) {
  std::vector<SensorCheck> checks;
  try {
    ready(asked.rig, stretches(asked.rig, asked.training), asked.options, &checks);
  } catch (const CannotAnswer&) {
  }
  std::vector<SensorFault> faults;
  for (const SensorCheck& check : checks) faults.insert(faults.end(), check.faults.begin(), check.faults.end());
  return faults;
}

}  // namespace diagnosis
