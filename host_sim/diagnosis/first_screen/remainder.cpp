#include "remainder.hpp"

#include <algorithm>

#include "../residual/lines.hpp"
#include "outsiders.hpp"

namespace diagnosis {
namespace {

constexpr double kFarBeyondNoise = 4;  // chi-squared per degree of freedom
constexpr double kSlowUncertain =
    0.003;  // of a strong effect's chi-squared where the slow motion it makes is not measured
// Of an outsider's threshold: the shape of friction near reversals is never quite met.
constexpr double kBesideFrictionShape = 5;

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

}  // namespace

bool far_beyond_noise(const Rows& rows, const SearchResult& found) {
  const double uncertain = rows.absolute() ? 0 : kSlowUncertain * found.base_fit.ratio();
  return found.fit.ratio() > std::max(kFarBeyondNoise, uncertain);
}

Remainder remainder_of(Rows& rows, const CandidateBank& bank, const SearchResult& found) {
  const double drop = (found.base_fit.chi2 - found.fit.chi2) / found.fit.dof;
  const double most = rows.absolute() ? 0.4 + 0.003 * drop : 0.6 + 0.01 * drop;
  Remainder left{found.fit.ratio() - 1 < most && !far_beyond_noise(rows, found), "", false};
  const Outsider outsider = outsider_of(rows, bank, found);
  const FusedRecord& f = rows.records()[0];
  const double ratio_beside = found.fit.chi2 / (found.fit.dof + outsider.score);
  if (outsider.present())
    left = {false, outsider.description, ratio_beside - 1 < most && !runs::of_mains(outsider.hertz, f.bin_Hz()),
            outsider.hertz, outsider.repeats_on};
  return left;
}

}  // namespace diagnosis
