// What is beyond chance and large enough, and which probe is named for it.
#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/identification/rows/backward_time.hpp"
#include "firmware/warrant/scores/score_test.hpp"

namespace firmware {
namespace {

constexpr int kDampingPercent = 3;
constexpr int kGainPercent = 2;       // bends a damper by as much
constexpr int kNamedGainPercent = 1;  // explains what something else shows
// The plain statistic cannot pass the root of the number of stretches that hold the information: it has to be most of
// that, or 3.
constexpr int kPlainLimit = 3, kPlainPercent = 80;
// What is beyond chance somewhere is named among all probes that see it with half a certainty: the right one may have its
// information in fewer stretches than its neighbours.
constexpr int kNamingLimit = 4;

// In tenths, over degrees of freedom.
struct Quantile {
  uint8_t freedom;
  uint16_t tenths[4];
};
constexpr Quantile kLimits[] = {{2, {3836, 1256, 192, 45}}, {3, {687, 326, 92, 33}}, {4, {306, 174, 66, 29}},
                                {5, {194, 123, 55, 26}},    {6, {145, 98, 49, 25}},  {8, {103, 76, 43, 24}},
                                {10, {85, 66, 40, 23}},     {12, {75, 60, 38, 22}},  {16, {65, 54, 35, 22}},
                                {20, {60, 50, 34, 21}},     {24, {57, 48, 33, 21}},  {32, {54, 46, 33, 21}},
                                {48, {51, 44, 32, 21}},     {64, {49, 43, 31, 20}},  {128, {47, 41, 31, 20}}};

// A rate that is made from the DOF's only channel: its noise is that of all else there.
bool derives_rates(const CoreConfiguration& configuration) {
  return one_quantity(configuration, Quantity::kDisplacement) || one_quantity(configuration, Quantity::kAcceleration);
}

Scaled limit(const Scaled& freedom, Chance chance) { return Scaled::ratio(tenths_of_limit(freedom, chance), 10); }

// Few stretches may hold most of the information (a sweep that passes a resonance, a blow): their own scatter is hardly known then,
// and its limits are wide. Noise that is alike in all stretches is known from all of them. Where it makes a force that rare,
// the few need to bear it out at a lower chance only for a finding, and for a doubt not at all.
bool beyond(const ProbeScore& score, Chance chance, const Scaled& share) {
  if (exceeds(score.wald, limit(score.freedom, chance) * share)) return true;
  if (!exceeds(score.even_wald, limit(score.even_freedom, chance) * share)) return false;
  return chance != Chance::kOfFinding || exceeds(score.wald, limit(score.freedom, Chance::kBearsOut) * share);
}

Scaled plain_limit(const Scaled& freedom) {
  const Scaled most = sqrt(freedom + kScaledOne) * Scaled::ratio(kPlainPercent, 100);
  return most < Scaled::from_int(kPlainLimit) ? most : Scaled::from_int(kPlainLimit);
}
Scaled percent(int value) { return Scaled::ratio(value, 100); }

// Friction that would push at small rates is no friction: a Stribeck force below that of the link's own friction comes from the
// tail of its law alone, where the direction is not yet clear, and says nothing.
bool pushes(const CoreConfiguration& configuration, const ProbePlan& plan, const Probe& probe, const ProbeScore& score,
            const Scaled* parameter) {
  const Place& place = plan.place[probe.place];
  if (probe.form != Form::kSignNarrow && probe.form != Form::kSignWide) return false;
  if (place.kind != PlaceKind::kLink) return false;
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    if (term.kind != TermKind::kCoulomb || term.place != place.link) continue;
    const Scaled& friction = term.unknown >= 0 ? parameter[term.unknown] : term.value;
    const Scaled both = forwards(configuration, TermKind::kCoulomb, score.effect + friction);
    return (both + scale_by_power_of_two(score.std, 1)).is_negative();
  }
  return false;
}

// The term that a probe of this form adds to, where physics keeps their sum positive; false: there is none.
bool term_like(Form form, PlaceKind kind, TermKind& term) {
  const bool rubs = form == Form::kSign || form == Form::kSignNarrow || form == Form::kSignWide;
  term = rubs ? TermKind::kCoulomb : form == Form::kRate ? TermKind::kViscous : TermKind::kStiffness;
  if (rubs || form == Form::kRate) return kind == PlaceKind::kLink || kind == PlaceKind::kNoLink;
  if (form == Form::kElongation) return kind == PlaceKind::kLink;
  term = TermKind::kMass;
  return form == Form::kAcceleration && kind == PlaceKind::kDof;
}

}  // namespace

// A damper or friction that would push together with what is there, a mass or a spring below nothing, a dead band that adds to the force:
// what is seen there is another cause. A pendulum's gravity holds it as a spring does.
bool ScoreTest::impossible(int number) const {
  const Probe& probe = sums_->plan().probe[number];
  const ProbeScore& score = score_[number];
  const Place& place = sums_->plan().place[probe.place];
  const Scaled twice = scale_by_power_of_two(score.std, 1);
  if (probe.form == Form::kForceWithinGap) return (score.effect + twice).is_negative();
  TermKind kind;
  if (probe.drifts() || !term_like(probe.form, place.kind, kind)) return false;
  Scaled of_rig;
  for (int t = 0; t < configuration_->term_count; ++t) {
    const Term& term = configuration_->terms[t];
    const bool holds = kind == TermKind::kStiffness && term.kind == TermKind::kGravity;
    const bool here = kind == TermKind::kMass ? term.place == place.node_a
                                              : place.kind == PlaceKind::kLink && term.place == place.link;
    if (here && (term.kind == kind || holds)) of_rig += coefficient(term);
  }
  // A pendulum that stands on its pivot has a spring below nothing.
  if (forwards(*configuration_, kind, of_rig).is_negative()) return false;
  return (forwards(*configuration_, kind, of_rig + score.effect) + twice).is_negative();
}

bool one_quantity(const CoreConfiguration& configuration, Quantity which) {
  for (int node = 0; node < configuration.dof_count; ++node) {
    const SignalConfiguration* const signal = configuration.signals[node];
    const auto measured = [&](Quantity q) {
      return signal[static_cast<int>(q)].available && !signal[static_cast<int>(q)].derived;
    };
    const SignalConfiguration& velocity = signal[static_cast<int>(Quantity::kVelocity)];
    if (!velocity.available || configuration.fuses(node)) continue;
    if (!velocity.derived && (measured(Quantity::kDisplacement) || measured(Quantity::kAcceleration))) continue;
    const auto source = velocity.derived ? static_cast<Quantity>(velocity.source) : Quantity::kVelocity;
    if (source == which) return true;
  }
  return false;
}

int tenths_of_limit(const Scaled& freedom, Chance chance) {
  const int column = static_cast<int>(chance);
  int tenths = kLimits[0].tenths[column];
  for (const Quantile& q : kLimits)
    if (freedom >= Scaled::from_int(q.freedom)) tenths = q.tenths[column];
  return tenths;
}

// As rare as the least that anything is made of, and not so rare that a scatter of four times as much (the most that a share of it
// makes) would leave it beyond all limits; and told by so few stretches that the place's coefficients take up over an eighth of them.
bool ScoreTest::near_chance(const ProbeScore& score) const {
  const bool one = kDerivesSignals && derives_rates(*configuration_);
  if (score.freedom > Scaled::from_int(8 * place_->columns)) return false;
  if (beyond(score, Chance::kOfFinding, Scaled::from_int(4))) return false;
  return beyond(score, one ? Chance::kOfOneQuantity : Chance::kBearsOut, seen_root_);
}

// A law of damping at a link of the rig: what may stand in the link's own coefficients before anything else.
bool ScoreTest::is_at_home(const Probe& probe) const {
  return needs_rate(probe.form) && sums_->plan().place[probe.place].kind == PlaceKind::kLink;
}

// A budget that leaves samples out leaves a force nearer to chance than the estimates' own samples would: the limit shrinks
// by the root of the share that was looked at. Of all 80 probes one is beyond three deviations in every fifth right record. Of the ten
// damping laws of a coefficient's own link one is for one in 40, and most of those would not bend it enough.
void ScoreTest::keep_bends(int number) {
  const ProbeScore& score = score_[number];
  const bool one = kDerivesSignals && derives_rates(*configuration_);
  if (!beyond(score, Chance::kOfOneQuantity, seen_root_)) return;
  const Probe& probe = sums_->plan().probe[number];
  if (pushes(*configuration_, sums_->plan(), probe, score, parameter_)) return;
  const bool doubted = one || beyond(score, Chance::kOfDoubt, seen_root_);
  const bool at_home = is_at_home(probe) && beyond(score, Chance::kBearsOut, seen_root_);
  const Scaled most = score.most(0);
  for (int k = 0; k < unknowns_; ++k) {
    const Scaled possible = most * abs(bend_[k]);
    if (doubted || (at_home && place_of_unknown_[k] == probe.place)) keep_larger(tested_[k].possible_bend, possible);
    keep_larger(tested_[k].unlikely_bend, possible);
  }
}

// Sum of squares of the forces of the rig's own damping terms: on a link its own, else (and where it has none) those of all
// links at the place's DOFs.
Scaled ScoreTest::damping_square(int number) const {
  const Place& place = sums_->plan().place[number];
  const Scaled own = place.kind == PlaceKind::kLink ? terms_square(number, true) : Scaled{};
  return own.is_zero() ? terms_square(number, false) : own;
}

Scaled ScoreTest::terms_square(int number, bool own) const {
  const ProbePlan& plan = sums_->plan();
  const Place& place = plan.place[number];
  Scaled sum;
  for (int t = 0; t < configuration_->term_count; ++t) {
    const Term& term = configuration_->terms[t];
    if (term.kind != TermKind::kViscous && term.kind != TermKind::kCoulomb) continue;
    const LinkConfiguration& link = configuration_->links[term.place];
    bool counts = own && place.link == term.place;
    for (int e = 0; e < place.equations && !own; ++e)
      counts = counts || link.node_a == place.dof[e] || link.node_b == place.dof[e];
    if (!counts) continue;
    const Form form = term.kind == TermKind::kViscous ? Form::kRate : Form::kSign;
    const Scaled& value = coefficient(term);
    for (int j = 0; j < plan.summed_count; ++j, report_work(20)) {
      const Place& at = plan.place_of(j);
      if (plan.probe[j].form == form && at.kind == PlaceKind::kLink && at.link == term.place)
        multiply_add(sum, square(value), abs(own_square_[j]));
    }
  }
  return sum;
}

Scaled ScoreTest::rate_kurtosis(int link) const {
  const ProbePlan& plan = sums_->plan();
  Scaled square_sum, fourth_sum;
  for (int j = 0; j < plan.summed_count; ++j) {
    const Place& place = plan.place_of(j);
    if (place.kind != PlaceKind::kLink || place.link != link) continue;
    if (plan.probe[j].form == Form::kRate) square_sum = own_square_[j];
    if (plan.probe[j].form == Form::kRateSquare) fourth_sum = own_square_[j];
  }
  return quotient(fourth_sum * samples_, square(square_sum));
}

Scaled ScoreTest::force_square(int number) const { return square(score_[number].effect) * abs(own_square_[number]); }

Scaled ScoreTest::force_ratio(int number) const {
  const Place& place = sums_->plan().place_of(number);
  const Scaled damping = compares_channels(place.kind) ? Scaled{} : damping_square(sums_->plan().probe[number].place);
  return damping.is_zero() ? kScaledOne : sqrt(force_square(number) / damping);
}

// A rig that is let go comes to rest where friction holds its springs bent, by up to its own force: a constant force of that size beside it
// says nothing against the model.
bool ScoreTest::is_held_by_friction(int number) const {
  const Probe& probe = sums_->plan().probe[number];
  if (probe.form != Form::kConstant || configuration_->window.mode != WindowMode::kFreeDecay) return false;
  const Place& place = sums_->plan().place[probe.place];
  Scaled friction;
  for (int t = 0; t < configuration_->term_count; ++t) {
    const Term& term = configuration_->terms[t];
    if (term.kind != TermKind::kCoulomb) continue;
    const LinkConfiguration& link = configuration_->links[term.place];
    bool beside = false;
    for (int e = 0; e < place.equations; ++e)
      beside = beside || link.node_a == place.dof[e] || link.node_b == place.dof[e];
    if (beside) friction += abs(coefficient(term));
  }
  return exceeds(friction, score_[number].effect);
}

void ScoreTest::judge_size(int number) {
  ProbeScore& score = score_[number];
  const Probe& probe = sums_->plan().probe[number];
  if (pushes(*configuration_, sums_->plan(), probe, score, parameter_)) score.tested = false;
  if (!score.tested) return;
  if (is_held_by_friction(number)) return;
  if (compares_channels(sums_->plan().place[probe.place].kind))
    score.matters = exceeds(score.effect, percent(kGainPercent));
  else
    score.matters = force_square(number) > square(percent(kDampingPercent)) * damping_square(probe.place);
  // The same with the scatter that the effect itself is in: the score over its root.
  const auto plain = [&] { return abs(score.effect * score.information) / sqrt(score.before); };
  score.flagged =
      score.matters && beyond(score, Chance::kOfFinding, kScaledOne) && plain() > plain_limit(score.freedom);
}

// The scatter of a place's scores per information is noise alone for the right probe; the smallest one stands for it.
void ScoreTest::name() {
  const ProbePlan& plan = sums_->plan();
  best_ = rival_ = -1;
  for (int p = 0; p < plan.place_count; ++p) {
    report_work(30 * plan.probe_count);
    const Scaled least = least_scatter(p);
    for (int j = 0; j < plan.probe_count; ++j)
      if (plan.probe[j].place == p && score_[j].tested)
        score_[j].gain = quotient(square(score_[j].effect) * score_[j].information, least);
  }
  bool any = false;
  for (int j = 0; j < plan.probe_count; ++j) any = any || score_[j].flagged;
  if (!any) return;
  bool any_possible = false;
  for (int j = 0; j < plan.probe_count; ++j) any_possible = any_possible || (score_[j].flagged && !impossible(j));
  // Channels that contradict each other need no model of the rig to be named.
  const auto of_channels = [&](int j) {
    return compares_channels(plan.place_of(j).kind) && score_[j].tested &&
           beyond(score_[j], Chance::kOfFinding, kScaledOne) && exceeds(score_[j].effect, percent(kNamedGainPercent));
  };
  const auto sees = [&](int j) {
    if (of_channels(j)) return true;
    if (any_possible && impossible(j)) return false;
    return score_[j].flagged || (score_[j].matters && exceeds(score_[j].wald, Scaled::from_int(kNamingLimit)));
  };
  const auto better = [&](int j, int than) {
    if (than >= 0 && of_channels(j) != of_channels(than)) return of_channels(j);
    return than < 0 || score_[j].gain > score_[than].gain;
  };
  for (int j = 0; j < plan.probe_count; ++j)
    if (sees(j) && better(j, best_)) best_ = j;
  if (best_ < 0) return;
  // The best of each place, held against each other by their own scatter: a place's smallest one is not that of another place.
  const Probe& named = plan.probe[best_];
  for (int p = 0; p < plan.place_count; ++p) {
    int at = -1;
    for (int j = 0; j < plan.probe_count; ++j) {
      const bool same = plan.probe[j].cause == named.cause && p == named.place;
      if (plan.probe[j].place == p && sees(j) && !same && better(j, at)) at = j;
    }
    if (at < 0) continue;
    const bool by_channels = rival_ >= 0 && of_channels(at) != of_channels(rival_);
    if (rival_ < 0 || (by_channels ? of_channels(at) : exceeds(score_[at].wald, score_[rival_].wald))) rival_ = at;
  }
}

}  // namespace firmware
