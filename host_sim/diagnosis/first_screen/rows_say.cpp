#include "rows_say.hpp"

#include <algorithm>
#include <memory>

#include "../sensors/fault_report.hpp"
#include "../sensors/trials.hpp"
#include "../terms/naming.hpp"
#include "../unseen/judge.hpp"
#include "../unseen/remainder.hpp"
#include "bench.hpp"
#include "limits.hpp"
#include "ranking.hpp"

namespace diagnosis {
namespace {

std::vector<host_sim::Record> first_parts(const std::vector<host_sim::Record>& records, double share) {
  std::vector<host_sim::Record> list = records;
  for (host_sim::Record& r : list) {
    const size_t keep = static_cast<size_t>(share * static_cast<double>(r.samples()));
    for (host_sim::Channel& c : r.channels) c.values.resize(keep);
  }
  return list;
}

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
    d.causes.push_back(c);
    for (const Found& r : found.rivals[i]) {
      const Term& other = r.candidate.term();
      d.ambiguous_with.push_back({word_of(other.kind), place_of(system, other, rows.records()[0])});
    }
  }
}

void also_ambiguous(const std::vector<NamedPlace>& rivals, Diagnosis& d) {
  d.ambiguous_with.insert(d.ambiguous_with.end(), rivals.begin(), rivals.end());
}

// Bars the first term that makes the free simulation of unseen data worse. True if there was one.
bool reject_worse(const System& system, const Judge& judge, const Rows& rows, CandidateBank& bank,
                  const SearchResult& found, Diagnosis& d) {
  const std::vector<ActiveTerm> fitted = judge.fitted(found.model);
  for (size_t i = 0; i < found.added.size(); ++i) {
    const Term mine = found.added[i].candidate.term();
    const std::vector<ActiveTerm> model = without_added(found.model, mine);
    if (!judge.clearly_worse(fitted, judge.fitted(model))) continue;
    Cause c;
    c.effect = word_of(mine.kind), c.where = place_of(system, mine, rows.records()[0]);
    c.significance = found.added[i].score;
    d.rejected.push_back(c);
    bank.bar(mine);
    return true;
  }
  return false;
}

void score_both(const Judge& judge, const std::vector<ActiveTerm>& base, const std::vector<ActiveTerm>& model,
                Diagnosis& d) {
  const HoldoutScore before = judge.score(base), after = judge.score(model);
  const auto take = [](const HoldoutScore& score, ModelScore& to) {
    to.holdout_nrmse_percent = score.nrmse_percent, to.holdout_mse_percent = score.mse_percent;
    to.holdout_velocity_nrmse_percent = score.velocity_percent;
  };
  take(before, d.baseline), take(after, d.extended);
  for (size_t j = 0; j < before.nrmse_percent.size(); ++j)
    d.gain.push_back(before.nrmse_percent[j] / std::max(1e-12, after.nrmse_percent[j]));
}

// Free simulation of unseen data rejects what makes it worse.
void simulate_unseen(const Asked& asked, Bench& bench, SearchResult& found, Remainder& remainder, Diagnosis& d) {
  const System& system = bench.system;
  const double share = asked.holdout.empty() ? 1 - asked.options.holdout_fraction : 1.0;
  const auto made_ready = [&](const std::vector<host_sim::Record>& records) {
    return imposed_on(ready(asked.rig, records, asked.options, nullptr), bench.imposed);
  };
  Bench early{system, asked.holdout.empty() ? made_ready(first_parts(asked.training, share)) : bench.records,
              bench.imposed};
  if (asked.holdout.empty()) sharpen_all(system, early.records);
  const Judge judge(system, bench.records, early.records, made_ready(asked.holdout), share);
  while (remainder.noise_only && bench.rows->absolute() && d.rejected.size() < kMostTerms &&
         reject_worse(system, judge, *bench.rows, *bench.bank, found, d)) {
    found = search(*bench.rows, *bench.bank);  // without it another may take its place
    d.extended_misfit = found.fit.ratio();
    remainder = remainder_of(*bench.rows, *bench.bank, found);
  }
  score_both(judge, judge.fitted(found.base), judge.fitted(found.model), d);
}

}  // namespace

RowsSay ask_rows(const System& system, const Asked& asked) {
  RowsSay say;
  Diagnosis& d = say.d;
  std::vector<SensorCheck> checks;
  auto owner = std::make_unique<Bench>(Bench{system, ready(asked.rig, asked.training, asked.options, &checks), {}});
  report_faults(checks, d);
  for (const SensorCheck& check : checks) say.faults.insert(say.faults.end(), check.faults.begin(), check.faults.end());
  owner->lay_out_sharpened();
  SensorCheck alone;
  SearchResult found = search_plain_first(owner, alone);
  try_holds(owner, found);
  const std::vector<NamedPlace> as_well = try_sole_channels(owner, found, alone);
  report_faults({alone}, d);
  for (const FusedRecord& f : owner->records)
    if (f.hold != Hold::kSmooth) d.force_between_samples = f.hold == Hold::kLinear ? "linear" : "steps";
  Bench& bench = *owner;
  d.baseline_misfit = found.base_fit.ratio(), d.extended_misfit = found.fit.ratio();
  Remainder remainder = remainder_of(*bench.rows, *bench.bank, found);
  say.noise_only = remainder.noise_only;
  d.unknown_trace = remainder.trace;
  if (!say.noise_only) return say;
  if (asked.options.simulate) simulate_unseen(asked, bench, found, remainder, d);
  say.noise_only = remainder.noise_only;
  Rows& rows = *bench.rows;
  report_terms(system, rows, found, d);
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
    ready(asked.rig, asked.training, asked.options, &checks);
  } catch (const CannotAnswer&) {
  }
  std::vector<SensorFault> faults;
  for (const SensorCheck& check : checks) faults.insert(faults.end(), check.faults.begin(), check.faults.end());
  return faults;
}

}  // namespace diagnosis
