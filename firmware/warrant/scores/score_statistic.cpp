// Effect, deviation and Wald statistic of one probe.
#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/warrant/scores/score_test.hpp"

namespace firmware {
namespace {

constexpr int kLeastFreedom = 2;
constexpr int kLeastShareLog2 = -6;  // of a force, not taken up by the estimated terms
constexpr int kApartLog2 = -2;       // the same, of one that is told apart well

// Stretches that show what noise does, each with at least 2^-10 of the mean information: below, rounding and products of noise.
constexpr int kFewestForEven = 16, kLeastInformationLog2 = -10;
constexpr int kGroupSizes = 3, kLeastGroups = 5;  // 2, 4 and 8 stretches

}  // namespace

void ScoreTest::keep_bend_of_shape(int number) {
  const ProbePlan& plan = sums_->plan();
  const Probe& probe = plan.probe[number];
  if (probe.form != Form::kRateSquare && probe.form != Form::kRateCube) return;
  const ProbeScore& score = score_[number];
  for (int k = 0; k < unknowns_; ++k) {
    if (place_of_unknown_[k] != probe.place) continue;
    keep_larger(tested_[k].bend_of_shape, score.most(1) * abs(bend_[k]));
  }
}

// A damping law that the estimated coefficients take up altogether. What a narrow Stribeck force is the wide one shows too. A damper
// between DOFs that no link joins: whose coefficient takes a good part of it up.
void ScoreTest::keep_blind(const Probe& probe) {
  const Place& place = sums_->plan().place[probe.place];
  const Form form = probe.form;
  if (place.kind == PlaceKind::kLink &&
      (form == Form::kRateSquare || form == Form::kRateCube || form == Form::kSignWide))
    blind_[place.link] = true;
  if (place.kind != PlaceKind::kNoLink || form != Form::kRate) return;
  const ProbePlan& plan = sums_->plan();
  for (int j = 0; j < plan.base_count; ++j) {
    const Probe& base = plan.probe[j];
    if (base.form == form && exceeds(bend_[base.unknown], Scaled::ratio(1, 4))) tested_[base.unknown].mimics = true;
  }
}

// Variance of the sum of the stretches' shares. Neighbours that err alike (slow noise in derived signals) show it in the sums of
// 2, 4 and 8 of them: where these scatter by more than independent ones do in one of 40 cases, 1 + 2 sqrt(2 / groups), they are
// what is independent, and there are so many fewer of them.
// All sums go through the stretches side by side: each waits for nothing but itself.
Scaled ScoreTest::variance_of_sum(const Scaled* share, Scaled& freedom) const {
  Scaled groups[kGroupSizes];
  int sizes = 0;
  for (; sizes < kGroupSizes; ++sizes) {
    groups[sizes] = freedom / (2 << sizes);
    if (groups[sizes] < Scaled::from_int(kLeastGroups)) break;
  }
  Scaled single, squares[kGroupSizes], sum[kGroupSizes];
  int in_group[kGroupSizes] = {};
  for (int s = 0; s < stretches_; ++s, report_work(80 * (1 + sizes))) {
    multiply_add(single, share[s], share[s]);
    const bool ends = s + 1 == stretches_ || level_of_[s + 1] != level_of_[s];
    for (int i = 0; i < sizes; ++i) {
      sum[i] += share[s];
      if (++in_group[i] < 2 << i && !ends) continue;
      multiply_add(squares[i], sum[i], sum[i]);
      sum[i] = Scaled{};
      in_group[i] = 0;
    }
  }
  Scaled variance = single;
  for (int i = 0; i < sizes; ++i) {
    const Scaled most = single * (kScaledOne + sqrt(Scaled::from_int(8) / groups[i]));
    if (squares[i] < most || squares[i] < variance) continue;
    variance = squares[i];
    freedom = groups[i];
  }
  return variance;
}

// Of the sum of the scores, were a stretch's in proportion to its information: the noise alike in all of them. From left_, what
// the effect leaves.
Scaled ScoreTest::even_variance(ProbeScore& result, const Scaled& lost) const {
  const Scaled least = scale_by_power_of_two(result.information / stretches_, kLeastInformationLog2);
  Scaled noise;
  int counted = 0;
  for (int s = 0; s < stretches_; ++s, report_work(350)) {
    if (d_[s] <= least) continue;
    noise += square(left_[s]) / d_[s];
    ++counted;
  }
  result.even_freedom = Scaled::from_int(counted - 1) - lost;
  return counted < kFewestForEven ? Scaled{} : noise * result.information / (counted - 1);
}

void ScoreTest::test(int number) {
  const Probe& probe = sums_->plan().probe[number];
  ProbeScore& result = score_[number] = ProbeScore{};
  open(probe);
  if (probe.drifts()) keep_times();
  const int own = place_->equations + place_->columns;
  for (int level = 0; level < levels_; ++level) own_square_[number] += total(level, own, 2);
  own_square_[number] *= unit_[own];
  if (probe.unknown >= 0) return;
  share_out();
  sum_own_ = Scaled{};
  for (int level = 0; level < levels_; ++level) score_level(level);
  if (!conclude(result)) return;
  judge_by_scatter(result);
  keep_bends(number);
  keep_bend_of_shape(number);
}

// An instrument that moves against what it stands for says the same with the other sign.
void ScoreTest::turn_round(ProbeScore& result) {
  for (int s = 0; s < stretches_; ++s, report_work(30)) {
    psi_[s] = -psi_[s];
    d_[s] = -d_[s];
  }
  result.information = -result.information;
}

// A damping law of which nobody knows how well the record tells it: so few stretches do that they show no scatter, or next to nothing of
// it is beyond what the estimated coefficients take up. What is found of it is not excluded. At its own link alone: there are ten such laws.
void ScoreTest::keep_unbounded(const ProbeScore& score) {
  if (!is_at_home(*probe_)) return;
  for (int k = 0; k < unknowns_; ++k) {
    if (place_of_unknown_[k] != probe_->place) continue;
    const Scaled bend = abs(score.effect * bend_[k]);
    keep_larger(tested_[k].possible_bend, bend);
    keep_larger(tested_[k].unlikely_bend, bend);
  }
}

// The effect. False: the record cannot tell it from the estimated coefficients, or too few stretches do. Where information of either
// sign cancels it is that of noise in the force, and what is found says nothing.
bool ScoreTest::conclude(ProbeScore& result) {
  Scaled sum_psi, d_squares;
  for (int s = 0; s < stretches_; ++s, report_work(200)) {
    sum_psi += psi_[s];
    result.information += d_[s];
    multiply_add(result.before, psi_[s], psi_[s]);
    multiply_add(d_squares, d_[s], d_[s]);
  }
  if (result.before.is_zero()) return false;
  const Scaled share = quotient(result.information, sum_own_);
  // Neighbours of so few samples a period that they move against the sample: no slope is taken from them either.
  const bool against = result.information.is_negative();
  result.effect = quotient(sum_psi, result.information);
  if (result.information.is_zero() || (against && compares_channels(place_->kind)) ||
      share < power_of_two(kLeastShareLog2)) {
    keep_blind(*probe_);
    // Friction whose direction is clear at fast motion alone takes a Stribeck force up.
    if (probe_->form == Form::kSignWide && !against) keep_unbounded(result);
    return false;
  }
  if (against) turn_round(result);
  result.freedom = square(result.information) / d_squares - kScaledOne;
  if (result.freedom < Scaled::from_int(kLeastFreedom)) {
    if (result.freedom >= Scaled::from_int(1)) keep_unbounded(result);
    return false;
  }
  result.tested = true;
  result.apart = share > power_of_two(kApartLog2);
  return true;
}

void ScoreTest::judge_by_scatter(ProbeScore& result) {
  const Scaled least = power_of_two(-2), part = kScaledOne / result.information;
  const Scaled doubtful = doubtful_score();  // while left_ still holds the times
  for (int s = 0; s < stretches_; ++s, report_work(200)) {
    Scaled& left = left_[s] = psi_[s];
    multiply_subtract(left, result.effect, d_[s]);
    multiply_add(result.scatter, left, left);
    Scaled rest = kScaledOne;
    multiply_subtract(rest, d_[s], part);
    if (rest < kScaledOne) left /= rest < least ? least : rest;
  }
  const Scaled freedom = result.freedom;
  weigh_up(result, Scaled{}, doubtful);
  if (!near_chance(result)) return;
  result.freedom = freedom;
  Scaled lost;
  for (int level = 0; level < levels_; ++level) lost += give_back_level(level, result);
  weigh_up(result, lost, doubtful);
}

// Deviation and Wald statistics from left_; lost: stretches that the estimated coefficients took up; doubtful: doubtful_score().
void ScoreTest::weigh_up(ProbeScore& result, const Scaled& lost, const Scaled& doubtful) {
  Scaled sum_psi;
  for (int s = 0; s < stretches_; ++s) sum_psi += psi_[s];
  const Scaled even = even_variance(result, lost), single = result.freedom;
  const Scaled deviation = sqrt(variance_of_sum(left_, result.freedom));
  Scaled doubt;  // what of the score may be noise that signals share, beyond what is taken out
  if (kKeepsProbeNoise) {
    for (int k = 0; k < unknowns_; ++k)
      if (!share_[k].is_zero()) multiply_add(doubt, share_[k], base_doubt_[k]);
    doubt = abs(doubtful - doubt);
  }
  const Scaled sure = beyond_doubt(abs(sum_psi), doubt);
  result.std = deviation / result.information;
  result.wald = quotient(sum_psi.is_negative() ? -sure : sure, deviation);
  // Where neighbours err alike nothing is alike in all.
  result.even_wald = {};
  if (result.freedom == single && !even.is_zero()) result.even_wald = result.wald * deviation / sqrt(even);
}

}  // namespace firmware
