// Faults of channels that no second one bears out.
#include <algorithm>
#include <cmath>
#include <utility>

#include "../search/sharpened_search.hpp"
#include "fault_report.hpp"
#include "sole_channels.hpp"
#include "trials.hpp"

namespace diagnosis {
namespace {

constexpr double kSame = 12;  // of chi-squared: two that differ by less explain as well
constexpr double kWorthTrying =
    0.5;                            // of what there is to explain: a true fault explains nine tenths at its first order
constexpr double kExplained = 0.1;  // chi-squared per degree of freedom beyond noise
constexpr double kRest = 0.05;      // of a residual, which sharper motion may still explain
constexpr double kLeft = 0.3;       // of its standard deviation: no further correction
constexpr double kStill = 0.9;      // of chi-squared before a step: no further one
constexpr double kPlain = 1.05;     // chi-squared per degree of freedom that one plain fault may explain at once
constexpr int kMostSteps = 6;
constexpr size_t kMostFaults = 2, kMostTried = 2;

// Fall of chi-squared that names a fault, as of any other candidate.
double threshold_of(const Bench& bench) { return bench.bank->threshold() * bench.bank->strictness(Kind::kForceGain); }

// With one mass a fault of its channel is one of the force.
bool set_apart(const Bench& bench) { return bench.system.dofs() > 1 && has_sole_channel(bench.records[0]); }

std::vector<SensorFault> faults_beside(const Rows& rows, std::vector<ActiveTerm> model) {
  const Fit fit = fit_model(rows, model);
  return sole_channel_faults(rows, model, fit);
}

// The records corrected for a fault, step by step until none is left beside a model.
struct Correction {
  std::unique_ptr<Bench> bench;  // to be laid out
  SensorFault fault;
  double ratio = 0;  // chi-squared per degree of freedom of the model then
};

Correction corrected(const Bench& bench, const std::vector<ActiveTerm>& model, const SensorFault& fault,
                     double before) {
  Correction c{std::make_unique<Bench>(Bench{bench.system, bench.records, bench.imposed}), fault, before};
  SensorFault step = fault;
  for (int i = 0; i < kMostSteps; ++i) {
    c.bench->records = imposed_on(std::move(c.bench->records), {{}, {step}});
    Rows rows(bench.system, c.bench->records);
    std::vector<ActiveTerm> copy = on_rows(rows, model);
    const Fit fit = settle(rows, copy, 2);
    const double last = std::exchange(c.ratio, fit.ratio());
    if (i + 1 == kMostSteps || c.ratio > kStill * last) break;
    const std::vector<SensorFault> list = sole_channel_faults(rows, copy, fit);
    const auto left =
        std::find_if(list.begin(), list.end(), [&](const SensorFault& f) { return same_fault(f, fault); });
    if (left == list.end() || std::hypot(left->value, left->quadrature) < kLeft * left->std) break;
    step = *left;
    accumulate(c.fault, step);
  }
  return c;
}

// Takes the corrected records in place of the others.
void adopt(std::unique_ptr<Bench>& owner, Correction correction, SensorCheck& check) {
  check.faults.push_back(correction.fault), check.rivals.emplace_back();
  owner = std::move(correction.bench);
  owner->imposed.faults.push_back(correction.fault);
}

SearchResult searched(std::unique_ptr<Bench>& bench) {
  bench->lay_out_sharpened();
  return search_sharpening(bench);
}

// What the terms of a result explain, over the noise that remains.
double explained_by(const SearchResult& found, const Rows& rows) {
  std::vector<ActiveTerm> base = found.base;
  return (fit_model(rows, base).chi2 - found.fit.chi2) / std::max(1.0, found.fit.ratio());
}

bool preferred(const SearchResult& again, const SensorFault& fault, const SearchResult& found, double explained) {
  const size_t terms = again.added.size() + 1, before = found.added.size();
  const double ratio = again.fit.ratio(), excess = found.fit.ratio() - 1;
  if (excess > kExplained && ratio - 1 < excess / 3) return true;
  if (terms < before) return ratio < kAsGood * found.fit.ratio();
  if (terms == before) return ratio < found.fit.ratio() / kAsGood || (terms == 1 && fault.score > explained + kSame);
  return terms == before + 1 && ratio < found.fit.ratio();
}

// Fewer terms that do as well, or as many that do better.
bool simpler(const SearchResult& a, const SearchResult& b) {
  if (a.added.size() != b.added.size() && (a.fit.ratio() < 1 + kExplained) == (b.fit.ratio() < 1 + kExplained))
    return a.added.size() < b.added.size();
  return a.fit.ratio() < b.fit.ratio();
}

// The fault to try next beside what was found, and the model beside which it showed.
struct Suspect {
  SensorFault fault;
  const std::vector<ActiveTerm>* model = nullptr;
};
std::vector<Suspect> suspects(const Bench& bench, const SearchResult& found, double explained) {
  std::vector<Suspect> list;
  const double threshold = threshold_of(bench);
  const bool settled =
      found.added.size() == 1 && found.fit.ratio() < 1 + kExplained;  // by one term: only its equal is of interest
  const double worth = settled ? explained - kSame : kWorthTrying * explained;
  for (const std::vector<ActiveTerm>* model : {&found.base, &found.model}) {
    if (model == &found.model && found.added.empty()) continue;
    const std::vector<SensorFault> faults = faults_beside(*bench.rows, *model);
    const double least =
        model == &found.base ? std::max(threshold, worth) : std::max(threshold, least_share(found.model) * explained);
    for (size_t i = 0; i < faults.size() && i < kMostTried && faults[i].score >= least; ++i)
      list.push_back({faults[i], model});
  }
  return list;
}

}  // namespace

std::vector<NamedPlace> equivalents(const Bench& bench, const SearchResult& found) {
  std::vector<NamedPlace> list;
  const DofSpectra& s = bench.records[0].spectra[0];
  if (bench.system.dofs() != 1 || s.count() != 1) return list;
  for (const Found& f : found.added)
    if (of_force_sensor(f.candidate.term().kind))
      list.push_back({word_of(f.candidate.term().kind), "channel " + s.channel[s.first()]});
  return list;
}

SearchResult search_plain_first(std::unique_ptr<Bench>& owner, SensorCheck& check) {
  if (!set_apart(*owner)) return search_sharpening(owner);
  std::vector<ActiveTerm> base = base_model(*owner->rows);
  const Fit fit = settle(*owner->rows, base, 3);
  std::vector<SensorFault> faults;
  if (fit.ratio() > kPlain) faults = sole_channel_faults(*owner->rows, base, fit);
  double term = 0;  // what one effect could explain
  if (!faults.empty())
    for (const Gain& gain : gains_of(*owner->rows, base, fit, owner->bank->beside(base)))
      term = std::max(term, gain.chi2);
  for (size_t i = 0; i < faults.size() && i < kMostTried; ++i) {
    const double explained = fit.chi2 * faults[i].score / (fit.dof + faults[i].score);
    if (explained < std::max(term, kWorthTrying * (fit.chi2 - fit.dof))) break;
    Correction trial = corrected(*owner, base, faults[i], fit.ratio());
    if (trial.ratio > 1 + std::max(kExplained, kRest * (fit.ratio() - 1))) continue;
    const SearchResult found = searched(trial.bench);
    if (!found.added.empty()) continue;
    adopt(owner, std::move(trial), check);
    return found;
  }
  return search_sharpening(owner);
}

std::vector<NamedPlace> try_sole_channels(std::unique_ptr<Bench>& owner, SearchResult& found, SensorCheck& check) {
  std::vector<NamedPlace> rivals;
  while (check.faults.size() < kMostFaults && set_apart(*owner)) {
    const double explained = explained_by(found, *owner->rows);
    Correction best;
    SearchResult best_found;
    for (const Suspect& s : suspects(*owner, found, explained)) {
      Correction trial = corrected(*owner, *s.model, s.fault, found.base_fit.ratio());
      const SearchResult again = searched(trial.bench);
      const bool as_well =
          again.added.empty() && found.added.size() == 1 && std::abs(s.fault.score - explained) < kSame;
      if (as_well) rivals.push_back(named_place(s.fault));
      if (!preferred(again, s.fault, found, explained) || (best.bench && !simpler(again, best_found))) continue;
      best = std::move(trial), best_found = again;
    }
    if (!best.bench) break;
    adopt(owner, std::move(best), check), found = best_found;
    rivals.clear();
  }
  return rivals;
}

std::vector<SensorFault> smallest_of_sole_channels(const Bench& bench, const SearchResult& found) {
  if (!has_sole_channel(bench.records[0])) return {};
  std::vector<SensorFault> list = faults_beside(*bench.rows, found.model);
  const double steps = seen_in_95_of_100(threshold_of(bench));
  for (SensorFault& fault : list) fault.value = steps * fault.std, fault.quadrature = 0;
  return list;
}

}  // namespace diagnosis
