#include <algorithm>
#include <cmath>
#include <memory>

#include "advice.hpp"
#include "beyond_noise.hpp"
#include "diagnosis.hpp"
#include "drive_hold.hpp"
#include "fault_report.hpp"
#include "limits.hpp"
#include "naming.hpp"
#include "outsiders.hpp"
#include "ranking.hpp"
#include "sharpen.hpp"

namespace diagnosis {
namespace {

constexpr double kFarBeyondNoise = 4;     // chi-squared per degree of freedom
constexpr double kWorthSharpening = 1.2;  // likewise
constexpr int kSlowRounds = 6;

// Fused records, corrected for the sensor faults that are found (collected where `faults` is given).
std::vector<FusedRecord> ready(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records,
                               const Options& options, std::vector<SensorCheck>* checks) {
  std::vector<FusedRecord> list;
  for (const host_sim::Record& r : records) {
    list.push_back(read_record(rig, r, options.top_of_band));
    estimate_noise(list.back());
    correct_hold(list.back());
    const SensorCheck check = check_sensors(list.back());
    if (checks) checks->push_back(check);
    fuse(list.back());
  }
  return list;
}

// Records and what is laid over them.
struct Bench {
  const System& system;
  std::vector<FusedRecord> records;
  std::unique_ptr<Rows> rows;
  std::unique_ptr<CandidateBank> bank;
  void lay_out() {
    rows = std::make_unique<Rows>(system, records);
    bank = std::make_unique<CandidateBank>(*rows);
  }
  // For a rig that is far from any model: the motion as measured, where there is motion, and weights to match.
  void look_wide() {
    for (FusedRecord& f : records) {
      fuse(f);
      f.last_bin = end_of_motion(f);
    }
    lay_out();
    colour_by_vocabulary(*rows, *bank);
  }
};

// Two rounds of fitting the rig as given and sharpening the motion by it.
void sharpen_all(const System& system, std::vector<FusedRecord>& records) {
  for (int pass = 0; pass < 2; ++pass) {
    Rows rows(system, records);
    std::vector<ActiveTerm> model = base_model(rows);
    settle(rows, model, 3);
    sharpen(records, system, model);
  }
}

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
      if (active.added && active.term.same_place(t)) c.parameters = parameters_of_term(system, active);
    d.causes.push_back(c);
    for (const Found& r : found.rivals[i]) {
      const Term& other = r.candidate.term();
      d.ambiguous_with.push_back({word_of(other.kind), place_of(system, other, rows.records()[0])});
    }
  }
}

// Bars the first term that makes the free simulation of unseen data worse. True if there was one.
bool reject_worse(const System& system, const Judge& judge, const Rows& rows, CandidateBank& bank, const SearchResult& found, Diagnosis& d) {
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

constexpr double kBesideFrictionShape = 5;  // of an outsider's threshold: the shape of friction near reversals is never quite met

// What friction leaves near reversals repeats with the elongation, which is at its ends there: no trace unless it shows
// with the reversals set aside.
bool shows_beside_reversals(Rows& rows, const CandidateBank& bank, std::vector<ActiveTerm> model) {
  Outsider wide;
  {
    const Rows::Look look(rows, Rows::Reversals::kWide);
    const Fit fit = settle(rows, model, 2);
    wide = strongest_outsider(rows, bank, model, fit);
  }
  settle(rows, model, 2);
  wide.threshold *= kBesideFrictionShape;
  return wide.present();
}

// A trace from outside the vocabulary that the final model leaves, or that explains more than one of its terms does.
Outsider outsider_of(Rows& rows, const CandidateBank& bank, const SearchResult& found) {
  // What a strong effect leaves by its imperfect shape is no trace of another.
  const double residue = (rows.absolute() ? 3e-5 : 1e-3) * std::max(0.0, found.base_fit.chi2 - found.fit.chi2);
  bool reversals = false;
  for (const Found& f : found.added) reversals = reversals || CandidateBank::friction_shape(f.candidate.term().kind);
  Outsider best = strongest_outsider(rows, bank, found.model, found.fit);
  best.threshold = (reversals ? kBesideFrictionShape : 1) * best.threshold + (reversals ? 10 : 1) * residue;
  if (best.present() && reversals && !shows_beside_reversals(rows, bank, found.model)) best = {};
  for (size_t i = 0; i < found.added.size() && !best.present(); ++i) {
    if (found.added[i].score > 20000) continue;  // nothing else comes near it
    std::vector<ActiveTerm> model = without_added(found.model, found.added[i].candidate.term());
    const Fit fit = fit_model(rows, model);
    Outsider other = strongest_outsider(rows, bank, model, fit);
    other.threshold = std::max(other.threshold, (fit.chi2 - found.fit.chi2) / std::max(1.0, found.fit.ratio()) + 20);
    if (other.present()) best = other;
  }
  return best;
}

// What the search's model leaves over, against sensor noise.
struct Remainder {
  bool noise_only = true;
  std::string trace;
};
Remainder remainder_of(const Bench& bench, const SearchResult& found) {
  const double drop = (found.base_fit.chi2 - found.fit.chi2) / found.fit.dof;
  Remainder left{found.fit.ratio() - 1 < (bench.rows->absolute() ? 0.4 + 0.003 * drop : 0.6 + 0.01 * drop) && found.fit.ratio() < kFarBeyondNoise, ""};
  const Outsider outsider = outsider_of(*bench.rows, *bench.bank, found);
  if (outsider.present()) left = {false, outsider.description};
  return left;
}

void score_both(const Judge& judge, const std::vector<ActiveTerm>& base, const std::vector<ActiveTerm>& model, Diagnosis& d) {
  const HoldoutScore before = judge.score(base), after = judge.score(model);
  const auto take = [](const HoldoutScore& score, ModelScore& to) {
    to.holdout_nrmse_percent = score.nrmse_percent, to.holdout_mse_percent = score.mse_percent;
    to.holdout_velocity_nrmse_percent = score.velocity_percent;
  };
  take(before, d.baseline), take(after, d.extended);
  for (size_t j = 0; j < before.nrmse_percent.size(); ++j)
    d.gain.push_back(before.nrmse_percent[j] / std::max(1e-12, after.nrmse_percent[j]));
}

}  // namespace

const char* verdict_word(Verdict v) {
  constexpr const char* kWords[] = {"none", "explained", "ambiguous", "unknown"};
  return kWords[static_cast<size_t>(v)];
}

Diagnosis diagnose(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                   const std::vector<host_sim::Record>& holdout, const Options& options) {
  if (training.empty()) throw CannotAnswer("no record to diagnose");
  Diagnosis d;
  const System system = make_system(rig);
  std::vector<SensorCheck> checks;
  auto owner = std::make_unique<Bench>(Bench{system, ready(rig, training, options, &checks), nullptr, nullptr});
  report_faults(checks, d);
  for (const FusedRecord& f : owner->records)
    if (f.hold != Hold::kSmooth) d.force_between_samples = f.hold == Hold::kLinear ? "linear" : "steps";
  sharpen_all(system, owner->records);
  owner->lay_out();
  SearchResult found = search(*owner->rows, *owner->bank);
  // what it found moves the reversals of friction, and the slow motion where that is not measured, in steps
  const int rounds = found.base_fit.ratio() <= kWorthSharpening ? 0 : owner->rows->absolute() ? 1 : kSlowRounds;
  for (int i = 0; i < rounds && !found.added.empty(); ++i) {
    auto sharper = std::make_unique<Bench>(Bench{system, owner->records, nullptr, nullptr});
    sharpen(sharper->records, system, found.model);
    sharper->lay_out();
    const SearchResult again = search(*sharper->rows, *sharper->bank);
    if (again.fit.ratio() >= found.fit.ratio()) break;
    found = again, owner = std::move(sharper);
    if (found.fit.ratio() < kWorthSharpening) break;
  }
  Bench& bench = *owner;
  d.baseline_misfit = found.base_fit.ratio(), d.extended_misfit = found.fit.ratio();
  Remainder remainder = remainder_of(bench, found);
  if (options.simulate) {
    const double share = holdout.empty() ? 1 - options.holdout_fraction : 1.0;
    Bench early{system, holdout.empty() ? ready(rig, first_parts(training, share), options, nullptr) : bench.records, nullptr, nullptr};
    if (holdout.empty()) sharpen_all(system, early.records);
    const Judge judge(system, bench.records, early.records, ready(rig, holdout, options, nullptr), share);
    const auto beyond_noise = [&] { return !remainder.noise_only && found.fit.ratio() > kFarBeyondNoise; };
    while (!beyond_noise() && bench.rows->absolute() && d.rejected.size() < kMostTerms &&
           reject_worse(system, judge, *bench.rows, *bench.bank, found, d)) {
      found = search(*bench.rows, *bench.bank);  // without it another may take its place
      d.extended_misfit = found.fit.ratio();
      remainder = remainder_of(bench, found);
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
  Rows& rows = *bench.rows;
  report_terms(system, rows, found, d);
  d.ranked = ranking(system, rows, *bench.bank, found, 12);
  d.baseline.parameters = parameters_of(system, found.base);
  d.extended.parameters = parameters_of(system, found.model);
  d.extended_rig = extended_rig(system, found.model);
  d.minimum_detectable = detection_limits(rows, *bench.bank, found.model, found.fit);
  for (const DetectionLimit& limit : fault_limits(checks)) d.minimum_detectable.push_back(limit);
  d.unknown_trace = remainder.trace;
  d.verdict = !remainder.noise_only ? Verdict::kUnknown
              : d.causes.empty() ? Verdict::kNone
              : d.ambiguous_with.empty() ? Verdict::kExplained : Verdict::kAmbiguous;
  d.advice = advice_for(d);
  return d;
}

}  // namespace diagnosis
