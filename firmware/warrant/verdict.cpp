#include "firmware/warrant/verdict.hpp"

#include "firmware/warrant/channel_fault.hpp"
#include "firmware/warrant/late_channel.hpp"

namespace firmware {
namespace {

constexpr int kImpossibleDeviations = 4;
// What a wrong value is: over 4 deviations and over 1/20 of it off.
constexpr int kWrongDeviations = 4, kWrongShare = 20;
constexpr int kOneTonePercent = 156;  // of the squared mean of w^2: mean of w^4

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

const Term* term_of(const CoreConfiguration& configuration, int unknown) {
  for (int t = 0; t < configuration.term_count; ++t)
    if (configuration.terms[t].unknown == unknown) return &configuration.terms[t];
  return nullptr;
}

// A displacement of another gain shows in the springs beside it too; a velocity does not.
bool gain_shows_in_springs(const CoreConfiguration& configuration, const Estimates& estimates, const ProbePlan& plan,
                           const ScoreTest& test, int probe) {
  const Place& place = plan.place[plan.probe[probe].place];
  for (int j = plan.base_count; j < plan.summed_count; ++j) {
    const Place& at = plan.place[plan.probe[j].place];
    if (plan.probe[j].form != Form::kElongation || at.kind != PlaceKind::kLink || !test.score(j).flagged) continue;
    if (at.node_a != place.node_a && at.node_b != place.node_a) continue;
    const Scaled stiffness = coefficient_at(configuration, estimates, TermKind::kStiffness, at.link);
    const Scaled least = abs(scale_by_power_of_two(stiffness * test.score(probe).effect, -2));
    if (abs(test.score(j).effect) > least) return true;
  }
  return false;
}

// The DOF's other pair of channels: acceleration and velocity beside velocity and displacement. -1: none that tells as small a gain.
int other_pair(const ProbePlan& plan, const ScoreTest& test, int probe) {
  const Place& place = plan.place[plan.probe[probe].place];
  const Scaled gain = abs(test.score(probe).effect);
  for (int j = plan.base_count; j < plan.summed_count; ++j) {
    const Place& at = plan.place[plan.probe[j].place];
    if (j == probe || !compares_channels(at.kind) || at.node_a != place.node_a) continue;
    return test.score(j).tested && scale_by_power_of_two(test.score(j).std, 2) < gain ? j : -1;
  }
  return -1;
}

Scaled up_to_one(Scaled gain) {
  const Scaled one = Scaled::from_int(1), size = abs(gain);
  return one < size ? one : size;
}

// Of two channels that contradict each other, steeper and flatter by one derivative, which is off? A velocity contradicts both
// its neighbours. Without a third channel a displacement shows in the springs beside it.
Quantity channel_off(const CoreConfiguration& configuration, const Estimates& estimates, const ProbePlan& plan,
                     const ScoreTest& test, int probe) {
  const bool of_acceleration = plan.place[plan.probe[probe].place].kind == PlaceKind::kAccelerationChannels;
  const int other = other_pair(plan, test, probe);
  if (other >= 0) {
    const Scaled gain = up_to_one(test.score(probe).effect), beside = up_to_one(test.score(other).effect);
    if (scale_by_power_of_two(beside, 1) > gain) return Quantity::kVelocity;
    return of_acceleration ? Quantity::kAcceleration : Quantity::kDisplacement;
  }
  if (of_acceleration) return Quantity::kAcceleration;
  return gain_shows_in_springs(configuration, estimates, plan, test, probe) ? Quantity::kDisplacement
                                                                            : Quantity::kVelocity;
}

// What holds its value from sample to sample acts half a sample later than what is measured.
bool is_half_a_sample(const CoreConfiguration& configuration, Scaled late_s) {
  const Scaled off = abs(scale_by_power_of_two(late_s, 1) + configuration.sample_period_s);
  return off * Scaled::from_int(100) < configuration.sample_period_s * Scaled::from_int(kSlipPercent);
}

Finding finding_of(const CoreConfiguration& configuration, const Estimates& estimates, const ProbePlan& plan,
                   const ScoreTest& test, int probe) {
  Finding finding;
  if (probe < 0) return finding;
  const Probe& p = plan.probe[probe];
  const Place& place = plan.place[p.place];
  finding.cause = p.cause;
  finding.quantity = p.quantity;
  finding.node_a = static_cast<int8_t>(place.node_a);
  if (p.quantity == kNoQuantity && place.kind != PlaceKind::kDof) finding.node_b = static_cast<int8_t>(place.node_b);
  const Scaled unit = fault_unit(configuration, estimates, p, place);
  finding.size = test.score(probe).effect * unit;
  finding.std = test.score(probe).std * abs(unit);
  if (p.form == Form::kForceRate && is_half_a_sample(configuration, finding.size))
    finding.cause = cause_of(EffectKind::kForceHold);
  if (p.cause != cause_of(EffectKind::kSensorGain)) return finding;
  if (compares_channels(place.kind)) {
    const Quantity off = channel_off(configuration, estimates, plan, test, probe);
    finding.quantity = static_cast<uint8_t>(off);
    if (off != static_cast<Quantity>(p.quantity)) {  // the flatter of the two
      finding.size = -finding.size;
      finding.cause = slip_of(Scaled::from_int(1) + finding.size, finding.cause);
      return finding;
    }
  }
  // The channel says 1 + e times the truth: e / (1 + e) of what it says is not so.
  const Scaled true_share = Scaled::from_int(1) - finding.size;
  if (true_share.is_zero()) return finding;
  finding.size /= true_share;
  finding.std /= true_share * true_share;
  finding.cause = slip_of(Scaled::from_int(1) + finding.size, finding.cause);
  return finding;
}

// What a late channel takes from an equation its estimated masses and springs pass on: they stand beside everything else.
bool spreads_skew(const CoreConfiguration& configuration, const Estimates& estimates) {
  bool skewed = false, passes_on = false;
  for (int k = 0; k < estimates.unknown_count; ++k) {
    const Term* term = term_of(configuration, k);
    skewed = skewed || estimates.parameters[k].status == EstimateStatus::kSkewed;
    passes_on = passes_on || (term != nullptr && is_in(kConservative, term->kind));
  }
  return skewed && passes_on;
}

// The scatter that the effect takes away, as amplitudes.
Scaled gained(const ProbeScore& score) {
  return score.before.is_zero() ? Scaled{} : Scaled::from_int(1) - sqrt(score.scatter / score.before);
}

void tell(const CoreConfiguration& configuration, const ScoreSums& sums, const ScoreTest& test, Estimates& estimates) {
  Warrant& warrant = estimates.warrant;
  const int best = test.best(), rival = test.rival();
  if (best < 0) return;
  warrant.named = finding_of(configuration, estimates, sums.plan(), test, best);
  warrant.rival = finding_of(configuration, estimates, sums.plan(), test, rival);
  warrant.force_ratio = test.force_ratio(best);
  warrant.gained = gained(test.score(best));
  if (rival >= 0) warrant.rival_share = test.score(rival).gain / test.score(best).gain;
}

bool impossible(const CoreConfiguration& configuration, int unknown, const ParameterEstimate& parameter) {
  const Term* term = term_of(configuration, unknown);
  return term != nullptr && is_in(kNotNegative, term->kind) && parameter.ci95_high.is_negative();
}

// So far on the impossible side that it is no chance: the model is wrong there, and bends the neighbours too.
bool contradicts(const CoreConfiguration& configuration, int unknown, const ParameterEstimate& parameter) {
  const Term* term = term_of(configuration, unknown);
  return term != nullptr && is_in(kNotNegative, term->kind) &&
         (parameter.value + parameter.std * Scaled::from_int(kImpossibleDeviations)).is_negative();
}

bool instruments_differ(const ScoreTest& test, int unknown, const ParameterEstimate& parameter) {
  const Scaled whole = abs(test.difference(unknown)), doubt = test.difference_doubt(unknown);
  const Scaled difference = whole > doubt ? whole - doubt : Scaled{};
  return difference > test.difference_std(unknown) * test.difference_limit(unknown) &&
         scale_by_power_of_two(difference, 1) > parameter.ci95_high - parameter.ci95_low &&
         difference * Scaled::from_int(40) > abs(parameter.value);
}

bool is_wrong_by(Scaled bend, const ParameterEstimate& parameter) {
  return bend > parameter.std * Scaled::from_int(kWrongDeviations) &&
         bend * Scaled::from_int(kWrongShare) > abs(parameter.value);
}

// What the score tests' own fit says of the value would make it wrong.
bool fits_differ(const ScoreTest& test, int unknown, const ParameterEstimate& parameter) {
  const Scaled whole = abs(test.difference(unknown)), doubt = test.difference_doubt(unknown);
  const Scaled difference = whole > doubt ? whole - doubt : Scaled{}, std = test.difference_std(unknown);
  return difference > std * Scaled::ratio(5, 2) && is_wrong_by(difference + std, parameter);
}

// The score tests' own fit hardly determines the coefficient: their instrument does not follow a motion of so few samples a period, and
// no force that would bend it shows.
bool hardly_tested(const ScoreTest& test, int unknown, const ParameterEstimate& parameter) {
  const Scaled std = test.difference_std(unknown);
  return std > parameter.std * Scaled::from_int(kLeastCertain) &&
         std * Scaled::from_int(kWrongShare) > abs(parameter.value);
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
  return test.blind(term->place) || is_wrong_by(test.bend_of_shape(unknown), parameter);
}

}  // namespace

void give_verdict(const CoreConfiguration& configuration, const ScoreSums& sums, const ScoreTest& test, TestState state,
                  Estimates& estimates) {
  Warrant& warrant = estimates.warrant;
  warrant = Warrant{};
  warrant.tested = state.judged;
  if (warrant.tested) tell(configuration, sums, test, estimates);
  Finding late;
  if (late_channel(configuration, estimates, late)) {
    if (state.judged) ask_equations(configuration, sums.plan(), test, estimates, late);
    warrant.rival = warrant.named;
    warrant.named = late;
  }
  const bool twice_derived = kDerivesSignals && one_quantity(configuration, Quantity::kDisplacement);
  const bool derived = twice_derived || (kDerivesSignals && (one_quantity(configuration, Quantity::kVelocity) ||
                                                             one_quantity(configuration, Quantity::kAcceleration)));
  bool contradicted = false;
  if (spreads_skew(configuration, estimates))
    for (int k = 0; k < estimates.unknown_count; ++k) raise(estimates.parameters[k], EstimateStatus::kSkewed);
  for (int k = 0; k < estimates.unknown_count; ++k)
    contradicted = contradicted || contradicts(configuration, k, estimates.parameters[k]);
  for (int k = 0; k < estimates.unknown_count; ++k) {
    ParameterEstimate& parameter = estimates.parameters[k];
    if (contradicted || impossible(configuration, k, parameter)) raise(parameter, EstimateStatus::kModelSuspect);
    if (!state.calibrated) continue;
    if (!state.judged) {  // where no window has closed there is nothing to test: STALE says so
      if (estimates.rows > 0) raise(parameter, EstimateStatus::kUntested);
      continue;
    }
    if (test.best() >= 0) raise(parameter, EstimateStatus::kModelSuspect);
    if (is_wrong_by(test.possible_bend(k), parameter) ||
        (derived && (fits_differ(test, k, parameter) || hardly_tested(test, k, parameter))) ||
        (twice_derived && blind(configuration, test, k)) || (estimates.inseparable && test.mimics(k)))
      raise(parameter, EstimateStatus::kUntested);
    if (instruments_differ(test, k, parameter)) raise(parameter, EstimateStatus::kBiasSuspect);
    // A second level asks the model another question.
    if (state.levels == 1 && one_amplitude(configuration, test, k, parameter))
      raise(parameter, EstimateStatus::kUntested);
  }
}

}  // namespace firmware
