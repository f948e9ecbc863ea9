#include "firmware/warrant/verdict/verdict.hpp"

#include "firmware/identification/rows/backward_time.hpp"
#include "firmware/warrant/probes/model_terms.hpp"
#include "firmware/warrant/verdict/finding.hpp"
#include "firmware/warrant/verdict/late_channel.hpp"

namespace firmware {
namespace {

constexpr int kImpossibleDeviations = 4;
// What a wrong value is: over 4 deviations and over 1/20 of it off.
constexpr int kWrongDeviations = 4, kWrongShare = 20;
constexpr int kDoubtedDeviations = 2;  // beyond its interval
constexpr int kOneTonePercent = 156;   // of the squared mean of w^2: mean of w^4

void raise(ParameterEstimate& parameter, EstimateStatus status) {
  if (severity(status) > severity(parameter.status)) parameter.status = status;
}

// A bit per TermKind, taken from the vocabulary when compiling: the table's words stay out of the image.
template <typename Is>
constexpr uint32_t terms_that(Is is) {
  uint32_t bits = 0;
  for (int t = 0; t < kTermKinds; ++t)
    if (is(row_of(static_cast<TermKind>(t)))) bits |= uint32_t{1} << t;
  return bits;
}
constexpr uint32_t kNotNegative = terms_that([](const EffectRow& row) { return row.sign == Sign::kNotNegative; });
constexpr uint32_t kConservative = terms_that([](const EffectRow& row) { return row.nature.conservative; });
bool is_in(uint32_t terms, TermKind kind) { return (terms >> static_cast<int>(kind) & 1) != 0; }

// What a late channel takes from an equation its estimated masses and springs pass on: they stand beside everything else.
bool spreads_skew(const CoreConfiguration& configuration, const Estimates& estimates) {
  if (!kHasDisplacementRows) return false;  // none is estimated
  bool skewed = false, passes_on = false;
  for (int k = 0; k < estimates.unknown_count; ++k) {
    const Term* term = term_of(configuration, k);
    skewed = skewed || estimates.parameters[k].status == EstimateStatus::kSkewed;
    passes_on = passes_on || (term != nullptr && is_in(kConservative, term->kind));
  }
  return skewed && passes_on;
}

void tell(const CoreConfiguration& configuration, const ScoreSums& sums, const ScoreTest& test, Estimates& estimates) {
  Warrant& warrant = estimates.warrant;
  const int best = test.best(), rival = test.rival();
  if (best < 0) return;
  warrant.named = finding_of(configuration, estimates, sums.plan(), test, best);
  warrant.rival = finding_of(configuration, estimates, sums.plan(), test, rival);
  warrant.force_ratio = test.force_ratio(best);
  warrant.gained = test.explained();
  warrant.naming = test.naming();
  if (rival >= 0) warrant.rival_share = test.score(rival).gain / test.score(best).gain;
}

// Are all numbers from the value to this side of its deviations below nought, and cannot be?
bool below_nought(const CoreConfiguration& configuration, int unknown, const Scaled& value, const Scaled& reach) {
  const Term* term = term_of(configuration, unknown);
  return term != nullptr && is_in(kNotNegative, term->kind) &&
         (forwards(configuration, term->kind, value) + reach).is_negative();
}

// The whole interval is on the impossible side: one right number in 40 that is nought is there by chance, and none is to be relied on.
bool impossible(const CoreConfiguration& configuration, int unknown, const ParameterEstimate& parameter) {
  return below_nought(configuration, unknown, parameter.ci95_high, {}) &&
         (!configuration.runs_back() || below_nought(configuration, unknown, parameter.ci95_low, {}));
}

// So far on that side that it is no chance: the model is wrong there, and bends the neighbours too. Not a number that the data do not
// determine, whose deviation says nothing.
bool contradicts(const CoreConfiguration& configuration, int unknown, const ParameterEstimate& parameter) {
  return severity(parameter.status) < severity(EstimateStatus::kIllConditioned) &&
         impossible(configuration, unknown, parameter) &&
         below_nought(configuration, unknown, parameter.value, parameter.std * kImpossibleDeviations);
}

// Do the two stand in an equation of motion together?
bool share_an_equation(const CoreConfiguration& configuration, int unknown, int other) {
  const ModelTerms model(configuration);
  const Term *one = term_of(configuration, unknown), *two = term_of(configuration, other);
  for (int dof = 0; dof < configuration.dof_count && one != nullptr && two != nullptr; ++dof)
    if (model.sign_in(*one, dof) != 0 && model.sign_in(*two, dof) != 0) return true;
  return false;
}

// What moves has a mass: where an equation does not tell it from nought, noise has taken its place, and the others' too.
bool loses_its_mass(const CoreConfiguration& configuration, int unknown, const ParameterEstimate& parameter) {
  const Term* term = kHasDisplacementRows ? term_of(configuration, unknown) : nullptr;  // else no mass is estimated
  return term != nullptr && term->kind == TermKind::kMass && parameter.status == EstimateStatus::kIllConditioned &&
         parameter.ci95_low.is_negative();
}

// What pushed a coefficient below nought had the others of its equations to bend too: by how much nobody can say.
void spread_impossible(const CoreConfiguration& configuration, Estimates& estimates) {
  bool beside[kMaxUnknowns] = {};
  for (int k = 0; k < estimates.unknown_count; ++k) {
    const ParameterEstimate& parameter = estimates.parameters[k];
    if (severity(parameter.status) > severity(EstimateStatus::kIllConditioned)) continue;
    if (!impossible(configuration, k, parameter) && !loses_its_mass(configuration, k, parameter)) continue;
    for (int j = 0; j < estimates.unknown_count; ++j) beside[j] = beside[j] || share_an_equation(configuration, k, j);
  }
  for (int j = 0; j < estimates.unknown_count; ++j)
    if (beside[j]) raise(estimates.parameters[j], EstimateStatus::kUntested);
}

Scaled sure_difference(const CoefficientTest& tested) {
  return beyond_doubt(abs(tested.difference), tested.difference_doubt);
}

bool instruments_differ(const CoefficientTest& tested, const ParameterEstimate& parameter) {
  const Scaled difference = sure_difference(tested);
  return difference > tested.difference_std * tested.difference_limit() &&
         scale_by_power_of_two(difference, 1) > parameter.ci95_high - parameter.ci95_low &&
         exceeds(difference * 40, parameter.value);
}

bool is_wrong_by(const Scaled& bend, const ParameterEstimate& parameter, int deviations = kWrongDeviations) {
  return bend > parameter.std * deviations && exceeds(bend * kWrongShare, parameter.value);
}

// What is missing is named, and whatever of what stands out it is, it bends the value by no more than its deviation, which the scatter
// holds that it makes from window to window.
bool stands_beside(const ScoreTest& test, const CoefficientTest& tested, const ParameterEstimate& parameter) {
  return test.names_a_force() && !(tested.named_bend > parameter.std);
}

// What the score tests' own fit says of the value would make it wrong. Where any one quantity is all, from two and a half deviations on.
// Else from four, whose size few stretches may tell: by Student's quantile it is not yet BIAS_SUSPECT then.
bool fits_differ(const CoefficientTest& tested, const ParameterEstimate& parameter, bool one_quantity) {
  const Scaled difference = sure_difference(tested);
  const Scaled& std = tested.difference_std;
  const Scaled deviations = one_quantity ? Scaled::ratio(5, 2) : Scaled::from_int(kWrongDeviations);
  return difference > std * deviations && is_wrong_by(difference + std, parameter);
}

// The score tests' own fit hardly determines the coefficient: their instrument does not follow a motion of so few samples a period, and
// no force that would bend it shows.
bool hardly_tested(const CoefficientTest& tested, const ParameterEstimate& parameter) {
  const Scaled& std = tested.difference_std;
  return std > parameter.std * kLeastCertain && exceeds(std * kWrongShare, parameter.value);
}

// A law that the link may have would not show.
bool blind(const CoreConfiguration& configuration, const ScoreTest& test, int unknown) {
  const Term* term = term_of(configuration, unknown);
  return term != nullptr && term->kind != TermKind::kMass && test.blind(term->place);
}

bool is_damping(TermKind kind) { return kind != TermKind::kMass && !is_in(kConservative, kind); }

// One amplitude of the rate: other damping laws differ from the estimated ones in their harmonics alone, and those have to be
// excluded one by one.
bool one_amplitude(const CoreConfiguration& configuration, const ScoreTest& test, int unknown,
                   const ParameterEstimate& parameter) {
  const Term* term = term_of(configuration, unknown);
  if (term == nullptr || !is_damping(term->kind)) return false;
  const Scaled shape = test.rate_kurtosis(term->place);
  if (shape.is_zero() || shape >= Scaled::ratio(kOneTonePercent, 100)) return false;
  return test.blind(term->place) || is_wrong_by(test.of(unknown).bend_of_shape, parameter);
}

// One law of a link is no better than the other: where one coefficient is in doubt, the other is too if a force that is
// as rare as one in 20 would put it beyond its interval and make it wrong.
void spread_doubt(const CoreConfiguration& configuration, const ScoreTest& test, Estimates& estimates) {
  bool in_doubt[kMaxLinks] = {};
  const auto damped_link = [&](int unknown) {
    const Term* term = term_of(configuration, unknown);
    return term != nullptr && is_damping(term->kind) ? term->place : -1;
  };
  for (int k = 0; k < estimates.unknown_count; ++k) {
    const EstimateStatus status = estimates.parameters[k].status;
    const bool doubted = status == EstimateStatus::kUntested || status == EstimateStatus::kBiasSuspect;
    if (doubted && damped_link(k) >= 0) in_doubt[damped_link(k)] = true;
  }
  for (int k = 0; k < estimates.unknown_count; ++k)
    if (damped_link(k) >= 0 && in_doubt[damped_link(k)] &&
        is_wrong_by(test.of(k).unlikely_bend, estimates.parameters[k], kDoubtedDeviations))
      raise(estimates.parameters[k], EstimateStatus::kUntested);
}

}  // namespace

void give_verdict(const CoreConfiguration& configuration, const ScoreSums& sums, const ScoreTest& test, TestState state,
                  Estimates& estimates) {
  Warrant& warrant = estimates.warrant;
  clear(warrant);
  warrant.tested = state.judged;
  if (warrant.tested) tell(configuration, sums, test, estimates);
  Finding late;
  if (late_channel(configuration, estimates, late)) {
    if (state.judged) ask_equations(configuration, sums.plan(), test, estimates, late);
    warrant.rival = warrant.named;
    warrant.named = late;
    warrant.naming = Naming::kExplains;  // by the channels' own identities: no force, no model of the rig
    warrant.gained = {};
  }
  const bool twice_derived = kDerivesSignals && one_quantity(configuration, Quantity::kDisplacement);
  const bool derived = twice_derived || (kDerivesSignals && (one_quantity(configuration, Quantity::kVelocity) ||
                                                             one_quantity(configuration, Quantity::kAcceleration)));
  // A motion read from its end begins where friction holds springs bent, by a force that nobody knows. It stands in the first friction's
  // equations, and is no fault of the model.
  const auto at_fault = configuration.runs_back() ? EstimateStatus::kUntested : EstimateStatus::kModelSuspect;
  bool contradicted = false;
  if (spreads_skew(configuration, estimates))
    for (int k = 0; k < estimates.unknown_count; ++k) raise(estimates.parameters[k], EstimateStatus::kSkewed);
  for (int k = 0; k < estimates.unknown_count; ++k)
    contradicted = contradicted || contradicts(configuration, k, estimates.parameters[k]);
  for (int k = 0; k < estimates.unknown_count; ++k) {
    ParameterEstimate& parameter = estimates.parameters[k];
    if (contradicted) raise(parameter, at_fault);
    if (!configuration.calibrates_tests()) continue;
    if (!state.judged) {  // where no window has closed there is nothing to test: STALE says so
      if (estimates.rows > 0) raise(parameter, EstimateStatus::kUntested);
      continue;
    }
    const CoefficientTest& tested = test.of(k);
    if (test.best() >= 0 && !stands_beside(test, tested, parameter)) raise(parameter, EstimateStatus::kModelSuspect);
    if (is_wrong_by(tested.possible_bend, parameter) || fits_differ(tested, parameter, derived) ||
        (derived && hardly_tested(tested, parameter)) || (twice_derived && blind(configuration, test, k)) ||
        (estimates.inseparable && tested.mimics))
      raise(parameter, EstimateStatus::kUntested);
    if (instruments_differ(tested, parameter)) raise(parameter, EstimateStatus::kBiasSuspect);
    // A second level asks the model another question.
    if (state.levels == 1 && one_amplitude(configuration, test, k, parameter))
      raise(parameter, EstimateStatus::kUntested);
  }
  spread_impossible(configuration, estimates);
  if (state.judged) spread_doubt(configuration, test, estimates);
}

}  // namespace firmware
