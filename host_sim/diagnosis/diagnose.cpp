#include <algorithm>
#include <cmath>
#include <memory>

#include "advice.hpp"
#include "answer/answer.hpp"
#include "bench.hpp"
#include "beyond_noise.hpp"
#include "diagnosis.hpp"
#include "fault_report.hpp"
#include "limits.hpp"
#include "naming.hpp"
#include "ranking.hpp"
#include "remainder.hpp"
#include "trials.hpp"

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

// What diagnose() was asked.
struct Asked {
  const rig_file::RigModel& rig;
  const std::vector<host_sim::Record>& training;
  const std::vector<host_sim::Record>& holdout;
  const Options& options;
};

// Free simulation of unseen data: rejects what makes it worse; far beyond noise it is the judge of what is named.
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
  const auto beyond_noise = [&] { return !remainder.noise_only && far_beyond_noise(*bench.rows, found); };
  while (!beyond_noise() && bench.rows->absolute() && d.rejected.size() < kMostTerms &&
         reject_worse(system, judge, *bench.rows, *bench.bank, found, d)) {
    found = search(*bench.rows, *bench.bank);  // without it another may take its place
    d.extended_misfit = found.fit.ratio();
    remainder = remainder_of(*bench.rows, *bench.bank, found);
  }
  if (beyond_noise()) {
    early.look_wide(), bench.look_wide();
    const SearchResult seen = search_by_simulation(*early.rows, *early.bank, judge);
    score_both(judge, seen.base, seen.model, d);
    found = transferred(seen, *bench.rows, *bench.bank);
    if (!found.added.empty()) remainder.trace.clear();  // it was of the model before
    Rows plain(system, bench.records);
    d.baseline_misfit = misfit(plain, found.base), d.extended_misfit = misfit(plain, found.model);
  } else {
    score_both(judge, judge.fitted(found.base), judge.fitted(found.model), d);
  }
}

}  // namespace

const char* verdict_word(Verdict v) {
  constexpr const char* kWords[] = {"none", "explained", "partly", "ambiguous", "unknown"};
  return kWords[static_cast<size_t>(v)];
}

namespace {

// What the equations' rows say, weighted by noise: right where their assumptions hold (a force, masses that are known, noise
// that is white or first order), and fast. noise_only: they do hold as far as what is left can tell.
struct RowsSay {
  Diagnosis d;
  bool noise_only = false;
  std::vector<SensorFault> faults;  // of motion channels, already taken out
  std::vector<Term> terms;          // that it names beside the rig's own
  std::vector<double> values;
};

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

bool massless(const rig_file::RigModel& rig) {
  return std::all_of(rig.dofs.begin(), rig.dofs.end(),
                     [](const rig_file::Dof& d) { return !d.mass_kg.estimate && d.mass_kg.value == 0; });
}

bool springs_and_masses_known(const rig_file::RigModel& rig) {
  return std::none_of(rig.dofs.begin(), rig.dofs.end(), [](const rig_file::Dof& d) { return d.mass_kg.estimate; }) &&
         std::none_of(rig.links.begin(), rig.links.end(),
                      [](const rig_file::Link& l) { return l.stiffness_N_m.estimate; });
}

// Gains and delays of motion channels as the simulation's candidates, one per channel and kind.
void add_faults(const std::vector<SensorFault>& faults, std::vector<runs::Candidate>& list,
                std::vector<double>& values) {
  for (const SensorFault& f : faults) {
    if (is_hum(f.kind)) continue;
    runs::Candidate c;
    c.terms = {on_dof(f.kind == FaultKind::kGain ? Kind::kChannelGain : Kind::kChannelDelay, static_cast<int>(f.dof))};
    c.terms[0].quantity = static_cast<int>(f.quantity);
    const auto same = [&](const runs::Candidate& o) { return o.same_place(c); };
    if (std::any_of(list.begin(), list.end(), same)) continue;  // of a further record
    list.push_back(c), values.push_back(f.value);
  }
}

bool two_channels_a_dof(const runs::Prepared& p) { return p.traces.size() > p.guess.size() - 1; }

// The rows' terms as the simulation's candidates; false where it has no such term.
bool as_candidates(const runs::Model& model, const RowsSay& say, std::vector<runs::Candidate>& list) {
  for (const Term& t : say.terms) {
    runs::Candidate c;
    c.terms = {t};
    if (t.kind >= Kind::kForceHumCos50 && t.kind <= Kind::kForceHumSin60) return false;
    if (t.kind == Kind::kBacklash || t.kind == Kind::kPresliding)
      for (size_t i = 0; i < model.size(); ++i)
        if (model[i].term.link == t.link &&
            (t.kind == Kind::kBacklash ? model[i].term.kind == Kind::kStiffness : model[i].term.kind == Kind::kCoulomb))
          c.host = static_cast<int>(i);
    list.push_back(c);
  }
  return true;
}

constexpr double kMostlyNoise = 0.8;  // of the squared residual

// The rows' answer stands where nothing is left beyond their noise and runs that have not seen the data bear it out.
bool rows_stand(const runs::Task& task, const runs::Choice& fitted, const RowsSay& say) {
  if (!say.noise_only) return false;
  std::vector<runs::Candidate> list;
  if (!as_candidates(fitted.base.model, say, list)) return true;
  std::vector<double> values = say.values;
  add_faults(say.faults, list, values);
  return list.empty() || runs::borne_out(task, fitted.base, list, values);
}

}  // namespace

Diagnosis diagnose(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                   const std::vector<host_sim::Record>& holdout, const Options& options) {
  if (training.empty()) throw CannotAnswer("no record to diagnose");
  const auto progress = [&](double share) {
    if (options.progress) options.progress(share);
  };
  const System system = make_system(rig);
  std::vector<host_sim::Record> all = training;
  all.insert(all.end(), holdout.begin(), holdout.end());
  const std::vector<runs::Prepared> records = runs::prepare_all(rig, all);
  const runs::Task task{system, records, training.size()};
  runs::Choice choice = runs::rig_fitted(task);
  progress(0.3);
  Diagnosis d;
  const bool right = !massless(rig) && runs::right(task, choice);
  const bool driven = runs::forced(records) && !massless(rig) && springs_and_masses_known(rig);
  if (!right) {
    if (driven && !choice.base_fits_nothing) {
      RowsSay say;
      try {
        say = ask_rows(system, {rig, training, holdout, options});
      } catch (const CannotAnswer&) {  // too few rows for them: the free runs alone
      }
      progress(0.6);
      if (rows_stand(task, choice, say)) {
        d = say.d;
        for (double gain : d.gain) d.remainder_percent.push_back(100 / std::max(gain, 1e-3));
        d.advice = advice_for(d);
        progress(1);
        return d;
      }
      d.unknown_trace = say.d.unknown_trace;
      choice.noise_is_enough = say.noise_only;
    } else if (!massless(rig)) {
      choice.noise_is_enough = runs::noise_share(choice.base_left, choice.base.fit) > kMostlyNoise;
    }
    if (!massless(rig) && two_channels_a_dof(records[0])) {
      std::vector<SensorCheck> checks;
      try {
        ready(rig, training, options, &checks);
      } catch (const CannotAnswer&) {
      }
      std::vector<SensorFault> faults;
      for (const SensorCheck& check : checks) faults.insert(faults.end(), check.faults.begin(), check.faults.end());
      std::vector<runs::Candidate> list;
      std::vector<double> values;
      add_faults(faults, list, values);
      if (!list.empty() && runs::borne_out(task, choice.base, list, values)) runs::adopt(task, list, values, choice);
    }
    runs::choose(task, choice, [&](double share) { progress(0.6 + 0.3 * share); });
  }
  runs::answer(task, choice, d);
  for (const std::string& advice : advice_for(d)) d.advice.push_back(advice);
  progress(1);
  return d;
}

}  // namespace diagnosis
