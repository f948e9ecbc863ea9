// What a probe's sums are, in SI units and with the noise that signals share taken out:
//   value = unit raw - sum over the slopes of noise (unit raw) of the slope,
// for its equations' known parts and its columns. A force that grows with time has the sums of the one before it, times the time.
#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/warrant/scores/score_test.hpp"

namespace firmware {

void ScoreTest::open(const Probe& probe) {
  const ProbePlan& plan = sums_->plan();
  probe_ = &probe;
  place_ = &plan.place[probe.place];
  for (int v = 0; v < plan.values(probe); ++v) unit_[v] = sums_->unit(probe, v);
  const int sums = place_->equations + place_->columns;
  for (int slope = 0; slope < shared_slopes(); ++slope)
    for (int v = 0; v < sums; ++v) noise_[slope][v] = sums_->noise_share(probe, slope, v, SharedNoise::Of::kWhole);
}

void ScoreTest::add_signed(Scaled& sum, int sign, const Scaled& x) {
  if (sign > 0) sum += x;
  if (sign < 0) sum -= x;
}

Scaled ScoreTest::taken(const Place& place, int column, const Scaled* g, int sign) {
  Scaled sum;
  for (int e = 0; e < place.equations; ++e) add_signed(sum, sign * place.column_sign[column][e], g[e]);
  return sum;
}

// Weights g of the place's equations: what they take of an unknown's column.
void ScoreTest::take_level(int level) {
  for (int k = 0; k < place_->columns; ++k, report_work(200))
    column_weight_[k] = taken(*place_, k, weight_[probe_->place][level], 1);
}

// The sum over equations and columns of factor times value.
void ScoreTest::add_sums(Combination<kMostProbeSums>& combination, const Scaled* factor) const {
  const int sums = place_->equations + place_->columns;
  for (int v = 0; v < sums; ++v)
    if (!factor[v].is_zero()) combination.add(probe_->first_value + v, factor[v] * unit_[v]);
  for (int slope = 0; slope < shared_slopes(); ++slope) {
    Scaled noise;
    for (int v = 0; v < sums; ++v)
      if (!factor[v].is_zero() && !noise_[slope][v].is_zero()) multiply_subtract(noise, factor[v], noise_[slope][v]);
    combination.add(probe_->first_value + sums + 1 + slope, noise * unit_[sums + 1 + slope]);
  }
}

// g' r, the residual at the estimates.
void ScoreTest::add_scores(Combination<kMostProbeSums>& combination, const Scaled* g) const {
  Scaled factor[kPlaceEquations + kMaxPlaceColumns];
  for (int e = 0; e < place_->equations; ++e) factor[e] = g[e];
  for (int k = 0; k < place_->columns; ++k, report_work(250)) {
    const Scaled part = taken(*place_, k, g, -1);
    if (!part.is_zero()) factor[place_->equations + k] = part * parameter_[place_->unknown[k]];
  }
  add_sums(combination, factor);
}

// Time in the middle of a stretch since its level's start; s.
Scaled ScoreTest::middle(int s) const {
  const Stretch& stretch = sums_->table().stretch(s);
  return configuration_->sample_period_s * Scaled::ratio(static_cast<int64_t>(stretch.time), stretch.blocks);
}

// Function of the time that the probe drifts with. end: the middle of its level's last stretch.
Scaled ScoreTest::time(int s, const Scaled& end) const {
  const Scaled since = middle(s);
  if (probe_->drift != Drift::kSettles) return since;
  const Scaled most = end + scale_by_power_of_two(end, -3), half = since + scale_by_power_of_two(end, -3);
  return half.is_zero() ? since : since * most / half;
}

void ScoreTest::keep_times() {
  for (int level = 0; level < levels_; ++level) {
    const Scaled end = end_of(level);
    for (int s = level_begin_[level]; s < level_begin_[level + 1]; ++s) left_[s] = time(s, end);
  }
}

// Sum of a value's raw sums over a level; power: of the time in it where the probe's force grows with time.
Scaled ScoreTest::total(int level, int value, int power) const {
  const ScoreTable& table = sums_->table();
  const int place = probe_->first_value + value, from = level_begin_[level], to = level_begin_[level + 1];
  if (!probe_->drifts()) return table.sum(from, to, place);
  Scaled sum;
  for (int s = from; s < to; ++s) {
    const Scaled& since = left_[s];  // keep_times()
    multiply_add(sum, table.value(s, place), power == 2 ? since * since : since);
  }
  return sum;
}

Scaled ScoreTest::column_total(int level, int column) const {
  const int value = place_->equations + column;
  Scaled sum = total(level, value, 1) * unit_[value];
  for (int slope = 0; slope < shared_slopes(); ++slope) {
    if (noise_[slope][value].is_zero()) continue;
    const int at = place_->equations + place_->columns + 1 + slope;
    multiply_subtract(sum, total(level, at, 1) * unit_[at], noise_[slope][value]);
  }
  return sum;
}

// What of the probe's whole score is noise of a doubtful size: the sums of its slopes, times the covariances.
Scaled ScoreTest::doubtful_score() {
  const Place& place = *place_;
  const int sums = place.equations + place.columns;
  Scaled doubt;
  for (int slope = 0; slope < shared_slopes(); ++slope) {
    const int at = sums + 1 + slope;
    Scaled share[kPlaceEquations];
    for (int v = 0; v < sums; ++v) {
      const Scaled noise = sums_->noise_share(*probe_, slope, v, SharedNoise::Of::kDoubtful) * unit_[at];
      if (noise.is_zero()) continue;
      if (v < place.equations) {
        share[v] += noise;
        continue;
      }
      const int k = v - place.equations;
      const Scaled part = parameter_[place.unknown[k]] * noise;
      for (int e = 0; e < place.equations; ++e) add_signed(share[e], -place.column_sign[k][e], part);
    }
    for (int level = 0; level < levels_; ++level) {
      const Scaled slopes = total(level, at, 1);
      for (int e = 0; e < place.equations; ++e)
        multiply_add(doubt, weight_[probe_->place][level][e] * slopes, share[e]);
    }
  }
  return doubt;
}

}  // namespace firmware
