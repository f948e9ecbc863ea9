// Of one probe: the scores of every stretch, less what the estimated coefficients take up.
#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/warrant/scores/score_test.hpp"

namespace firmware {

// How the score of each estimated term answers to the probe's force at a level: only equations that both stand in.
void ScoreTest::find_answers(int level) {
  const ProbePlan& plan = sums_->plan();
  for (int k = 0; k < place_->columns; ++k, report_work(200)) {
    Scaled& answer = answer_[k] = Scaled{};
    if (!determined_[place_->unknown[k]]) continue;
    const int base = place_of_unknown_[place_->unknown[k]];
    for (int f = 0; f < plan.place[base].equations; ++f)
      for (int e = 0; e < place_->equations; ++e)
        if (plan.place[base].dof[f] == place_->dof[e]) add_signed(answer, place_->sign[e], weight_[base][level][f]);
  }
}

// C and b.
void ScoreTest::share_out() {
  Scaled taken[kMaxUnknowns], answered[kMaxUnknowns];
  for (int level = 0; level < levels_; ++level) {
    take_level(level);
    find_answers(level);
    for (int k = 0; k < place_->columns; ++k) {
      const int unknown = place_->unknown[k];
      const Scaled column = column_total(level, k);
      multiply_add(taken[unknown], column_weight_[k], column);
      multiply_add(answered[unknown], answer_[k], column);
    }
  }
  for (int k = 0; k < unknowns_; ++k) {
    share_[k] = bend_[k] = Scaled{};
    for (int j = 0; j < unknowns_; ++j) {
      if (!taken[j].is_zero() && !inverse_[j][k].is_zero()) multiply_add(share_[k], taken[j], inverse_[j][k]);
      if (!answered[j].is_zero() && !inverse_[k][j].is_zero()) multiply_add(bend_[k], inverse_[k][j], answered[j]);
    }
  }
}

// C N_s: base_sum_ gets the values of the table that stand in it, each as it counts, and where times is given times that of its unknown.
// unknown_of, where it is given: the unknown of each; returns how many there are.
int ScoreTest::list_base_sums(int level, const Scaled* times, uint8_t* unknown_of) {
  int count = 0;
  base_sum_.clear();
  const ProbePlan& plan = sums_->plan();
  for (int j = 0; j < plan.base_count; ++j) {
    const Probe& base = plan.probe[j];
    const Place& place = plan.place[base.place];
    const Scaled& share = share_[base.unknown];
    if (share.is_zero()) continue;
    for (int k = 0; k < place.columns; ++k) {
      report_work(250);
      const Scaled part = taken(place, k, weight_[base.place][level], 1);
      if (part.is_zero()) continue;
      const int value = place.equations + k, unknown = place.unknown[k];
      Scaled counts = share * part * sums_->unit(base, value);
      if (times != nullptr) counts *= times[unknown];
      if (unknown_of != nullptr) unknown_of[count++] = static_cast<uint8_t>(unknown);
      base_sum_.add(base.first_value + value, counts);
    }
  }
  return count;
}

// The estimated coefficients are fitted to the same stretches. They take up g' (sum N)^-1 g of a score's variance d, with
// g = G_s - C N_s: much where a few stretches hold what there is to know. Divides left_ of the level's stretches by what is left of it,
// beside the effect's own share h of the information. Returns the sum of the shares that they take up.
Scaled ScoreTest::give_back_level(int level, const ProbeScore& result) {
  const ScoreTable& table = sums_->table();
  const Scaled least = power_of_two(-2), part = kScaledOne / result.information, end = end_of(level);
  uint8_t unknown_of[kMostBaseSums];
  Scaled lost;
  take_level(level);
  const int count = list_base_sums(level, nullptr, unknown_of);
  for (int s = level_begin_[level]; s < level_begin_[level + 1]; ++s) {
    const Scaled& d = d_[s];
    Scaled g[kMaxUnknowns], taken;
    for (int k = 0; k < place_->columns; ++k) {
      const int value = place_->equations + k;
      Scaled& of_unknown = g[place_->unknown[k]];
      of_unknown = column_weight_[k] * unit_[value] * table.value(s, probe_->first_value + value);
      if (probe_->drifts()) of_unknown *= time(s, end);
    }
    for (int i = 0; i < count; ++i) g[unknown_of[i]] -= base_sum_.term(table, s, i);
    report_work(150 * count);
    for (int i = 0; i < unknowns_; ++i) {
      if (g[i].is_zero()) continue;
      for (int j = 0; j < unknowns_; ++j)
        if (!g[j].is_zero()) multiply_add(taken, g[i] * inverse_[i][j], g[j]);
      report_work(150 * unknowns_);
    }
    Scaled share, rest = kScaledOne;
    if (d.is_positive()) share = abs(taken) / d;
    lost += share < kScaledOne ? share : kScaledOne;
    multiply_subtract(rest, d, part);
    rest -= share;
    Scaled& left = left_[s] = psi_[s];
    multiply_subtract(left, result.effect, d);
    left /= rest < least ? least : rest;
  }
  return lost;
}

// psi and d of the level's stretches.
void ScoreTest::score_level(int level) {
  const ScoreTable& table = sums_->table();
  const int own = place_->equations + place_->columns;
  const Scaled* g = weight_[probe_->place][level];
  take_level(level);
  find_answers(level);
  score_sum_.clear();
  column_sum_.clear();
  add_scores(score_sum_, g);
  Scaled factor[kPlaceEquations + kMaxPlaceColumns], own_weight;
  for (int k = 0; k < place_->columns; ++k) {
    const int unknown = place_->unknown[k];
    factor[place_->equations + k] = -(share_[unknown] * answer_[k] + bend_[unknown] * column_weight_[k]);
  }
  add_sums(column_sum_, factor);
  for (int e = 0; e < place_->equations; ++e) add_signed(own_weight, place_->sign[e], g[e]);
  own_weight *= unit_[own];
  if (!probe_->drifts()) column_sum_.add(probe_->first_value + own, own_weight);
  list_base_sums(level, bend_, nullptr);  // C N_s b: what the bent estimates do to the scores of the estimated terms
  ShortScaled share[kMaxUnknowns];
  for (int k = 0; k < unknowns_; ++k) share[k] = short_scaled(share_[k]);
  const int from = level_begin_[level], to = level_begin_[level + 1];
  score_sum_.of_all(table, from, to, psi_);
  column_sum_.of_all(table, from, to, d_);
  for (int s = from; s < to; ++s, report_work(600 + 100 * unknowns_)) {
    const Scaled base = sum_of_arrays<kMaxUnknowns>(unknowns_, share, base_score_[s]);
    if (probe_->drifts()) {
      const Scaled& since = left_[s];
      psi_[s] *= since;
      multiply_add(d_[s], own_weight * table.value(s, probe_->first_value + own), since);
      d_[s] *= since;
    }
    psi_[s] -= base;
  }
  base_sum_.add_all(table, from, to, d_);
  multiply_add(sum_own_, own_weight, total(level, own, 2));
}

}  // namespace firmware
