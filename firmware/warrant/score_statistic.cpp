// Effect, deviation and Wald statistic of one probe.
#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/warrant/score_test.hpp"

namespace firmware {
namespace {

constexpr int kLeastFreedom = 2;
constexpr int kFoundDeviations = 2;  // chance finds as much of one force in 20
constexpr int kLeastShareLog2 = -6;  // of a force, not taken up by the estimated terms

constexpr int kMostInGroup = 8, kLeastGroups = 5;

Scaled square(Scaled value) { return value * value; }
Scaled quotient(Scaled a, Scaled b) { return b.is_zero() ? Scaled{} : a / b; }

}  // namespace

// What the scores of the place take of an unknown's column.
void ScoreTest::find_weights(const Probe& probe) {
  const Place& place = sums_->plan().place[probe.place];
  for (int level = 0; level < levels_; ++level)
    for (int k = 0; k < place.columns; ++k) {
      Scaled& sum = column_weight_[level][k] = Scaled{};
      for (int e = 0; e < place.equations; ++e) {
        const Scaled g = weight_[probe.place][level][e];
        if (place.column_sign[k][e] > 0) sum = sum + g;
        if (place.column_sign[k][e] < 0) sum = sum - g;
      }
    }
}

// C and, once the answers are known, how a unit of the probe's effect bends the estimates.
void ScoreTest::share_out(const Probe& probe) {
  const ProbePlan& plan = sums_->plan();
  const Place& place = plan.place[probe.place];
  Scaled sum[kMaxUnknowns], total[kMaxUnknowns];
  for (int s = 0; s < stretches_; ++s)
    for (int k = 0; k < place.columns; ++k) {
      const int unknown = place.unknown[k];
      sum[unknown] = sum[unknown] + taken(s, k);
      total[unknown] = total[unknown] + answer_[level_of_[s]][k] * column_[s][k];
    }
  for (int k = 0; k < unknowns_; ++k) {
    share_[k] = bend_[k] = Scaled{};
    for (int j = 0; j < unknowns_; ++j) {
      if (!sum[j].is_zero() && !inverse_[j][k].is_zero()) share_[k] = share_[k] + sum[j] * inverse_[j][k];
      if (!total[j].is_zero() && !inverse_[k][j].is_zero()) bend_[k] = bend_[k] + inverse_[k][j] * total[j];
    }
  }
}

// How the score of each estimated term answers to the probe's force: only equations that both stand in.
void ScoreTest::find_answers(const Probe& probe) {
  const ProbePlan& plan = sums_->plan();
  const Place& place = plan.place[probe.place];
  for (int level = 0; level < levels_; ++level)
    for (int k = 0; k < place.columns; ++k) {
      Scaled& answer = answer_[level][k] = Scaled{};
      if (!determined_[place.unknown[k]]) continue;
      const int base = place_of_unknown_[place.unknown[k]];
      for (int f = 0; f < plan.place[base].equations; ++f)
        for (int e = 0; e < place.equations; ++e)
          if (plan.place[base].dof[f] == place.dof[e]) {
            const Scaled g = weight_[base][level][f];
            answer = answer + (place.sign[e] < 0 ? -g : g);
          }
    }
}

// C N_s b: what the bent estimates do to the scores of the estimated terms, stretch by stretch.
void ScoreTest::bend_base(Scaled* bent) const {
  const ProbePlan& plan = sums_->plan();
  for (int s = 0; s < stretches_; ++s, report_work(60)) bent[s] = Scaled{};
  for (int j = 0; j < plan.base_count; ++j) {
    const Probe& base = plan.probe[j];
    const Place& place = plan.place[base.place];
    const Scaled share = share_[base.unknown];
    if (share.is_zero()) continue;
    for (int k = 0; k < place.columns; ++k) {
      const Scaled bend = share * bend_[place.unknown[k]];
      if (bend.is_zero()) continue;
      const int value = place.equations + k;
      const Scaled scale = bend * sums_->unit(base, value);
      Scaled factor[kMaxLevels];
      for (int level = 0; level < levels_; ++level)
        for (int e = 0; e < place.equations; ++e) {
          const Scaled g = weight_[base.place][level][e];
          if (place.column_sign[k][e] > 0) factor[level] = factor[level] + g * scale;
          if (place.column_sign[k][e] < 0) factor[level] = factor[level] - g * scale;
        }
      for (int s = 0; s < stretches_; ++s)
        bent[s] = bent[s] + factor[level_of_[s]] * sums_->table().value(s, base.first_value + value);
    }
  }
}

void ScoreTest::keep_bend_of_shape(int number) {
  const ProbePlan& plan = sums_->plan();
  const Probe& probe = plan.probe[number];
  if (probe.form != Form::kRateSquare && probe.form != Form::kRateCube) return;
  const ProbeScore& score = score_[number];
  for (int k = 0; k < unknowns_; ++k) {
    if (place_of_unknown_[k] != probe.place) continue;
    const Scaled bend = (abs(score.effect) + scale_by_power_of_two(score.std, 1)) * abs(bend_[k]);
    if (bend > bend_of_shape_[k]) bend_of_shape_[k] = bend;
  }
}

// A damping law that the estimated coefficients take up altogether. What a narrow Stribeck force is the wide one shows too.
void ScoreTest::keep_blind(const Probe& probe) {
  const Place& place = sums_->plan().place[probe.place];
  const Form form = probe.form;
  if (place.kind == PlaceKind::kLink &&
      (form == Form::kRateSquare || form == Form::kRateCube || form == Form::kSignWide))
    blind_[place.link] = true;
}

// Variance of the sum of the stretches' shares. Neighbours that err alike (slow noise in derived signals) show it in the sums of
// 2, 4 and 8 of them: where these scatter by more than independent ones do in one of 40 cases, 1 + 2 sqrt(2 / groups), they are
// what is independent, and there are so many fewer of them.
Scaled ScoreTest::variance_of_sum(const Scaled* share, Scaled& freedom) const {
  Scaled variance;
  for (int s = 0; s < stretches_; ++s) variance = variance + square(share[s]);
  const Scaled single = variance, stretches = freedom;
  for (int size = 2; size <= kMostInGroup; size *= 2) {
    const Scaled groups = stretches / Scaled::from_int(size);
    if (groups < Scaled::from_int(kLeastGroups)) break;
    Scaled squares, sum;
    int in_group = 0;
    for (int s = 0; s < stretches_; ++s, report_work(80)) {
      sum = sum + share[s];
      if (++in_group < size && s + 1 < stretches_ && level_of_[s + 1] == level_of_[s]) continue;
      squares = squares + square(sum);
      sum = Scaled{};
      in_group = 0;
    }
    const Scaled most = single * (Scaled::from_int(1) + sqrt(Scaled::from_int(8) / groups));
    if (squares < most || squares < variance) continue;
    variance = squares;
    freedom = groups;
  }
  return variance;
}

void ScoreTest::test(int number) {
  const Probe& probe = sums_->plan().probe[number];
  const Place& place = sums_->plan().place[probe.place];
  ProbeScore& result = score_[number] = ProbeScore{};
  read(probe);
  for (int s = 0; s < stretches_; ++s, report_work(80)) own_square_[number] = own_square_[number] + own_[s];
  if (probe.unknown >= 0) return;
  find_answers(probe);
  find_weights(probe);
  share_out(probe);
  for (int level = 0; level < levels_; ++level)
    for (int k = 0; k < place.columns; ++k) shared_answer_[level][k] = share_[place.unknown[k]] * answer_[level][k];
  Scaled *psi = psi_, *d = d_;
  bend_base(d);
  Scaled sum_psi, sum_d, sum_p, d_squares;
  for (int s = 0; s < stretches_; ++s) {
    psi[s] = Scaled{};
    Scaled own;
    for (int e = 0; e < place.equations; ++e) {
      const Scaled g = weight(probe.place, s, e);
      psi[s] = psi[s] + g * residual_[s][e];
      own = own + (place.sign[e] < 0 ? -g : g) * own_[s];
    }
    for (int k = 0; k < unknowns_; ++k)
      if (!share_[k].is_zero()) psi[s] = psi[s] - share_[k] * base_score_[s][k];
    d[s] = d[s] + own;
    for (int k = 0; k < place.columns; ++k)
      d[s] = d[s] - shared_answer_[level_of_[s]][k] * column_[s][k] - bend_[place.unknown[k]] * taken(s, k);
    sum_p = sum_p + own;
    sum_psi = sum_psi + psi[s];
    sum_d = sum_d + d[s];
    result.before = result.before + square(psi[s]);
    d_squares = d_squares + square(d[s]);
  }
  result.score = sum_psi;
  result.information = sum_d;
  result.share = quotient(sum_d, sum_p);
  if (result.before.is_zero()) return;
  if (sum_d.is_zero() || result.share < Scaled::from_int(1, kLeastShareLog2)) return keep_blind(probe);
  result.freedom = square(sum_d) / d_squares - Scaled::from_int(1);
  if (result.freedom < Scaled::from_int(kLeastFreedom)) return;
  result.tested = true;
  result.effect = sum_psi / sum_d;
  Scaled* left = own_;  // read no more
  for (int s = 0; s < stretches_; ++s) {
    left[s] = psi[s] - result.effect * d[s];
    result.scatter = result.scatter + square(left[s]);
    Scaled rest = Scaled::from_int(1) - d[s] / sum_d;
    if (rest < Scaled::ratio(1, 4)) rest = Scaled::ratio(1, 4);
    if (rest > Scaled::from_int(1)) rest = Scaled::from_int(1);
    left[s] = left[s] / rest;
  }
  const Scaled variance = variance_of_sum(left, result.freedom);
  Scaled doubt;  // what of the score may be noise that signals share, beyond what is taken out
  for (int k = 0; k < unknowns_; ++k)
    if (!share_[k].is_zero()) doubt = doubt + share_[k] * base_doubt_[k];
  doubt = abs(doubtful_score(probe.place) - doubt);
  const Scaled sure = abs(sum_psi) > doubt ? abs(sum_psi) - doubt : Scaled{};
  result.std = sqrt(variance) / sum_d;
  result.wald = quotient(sum_psi.is_negative() ? -sure : sure, sqrt(variance));
  result.plain = sum_psi / sqrt(result.before);
  keep_bends(number);
  keep_bend_of_shape(number);
}

}  // namespace firmware
