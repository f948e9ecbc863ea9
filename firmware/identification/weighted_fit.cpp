#include "firmware/identification/weighted_fit.hpp"

namespace firmware {
namespace {

constexpr int kReweightings = 2;

Scaled column_square(const BatchTable& table, Weight weight, int n) {
  Scaled sum;
  for (int l = 0; l < table.level_count; ++l)
    for (int b = 0; b < table.level[l].batch_count; ++b) {
      const Scaled value = unpack(table.level[l].batch[b].column[static_cast<int>(weight)][n]);
      sum = sum + value * value;
    }
  return sum;
}

// How much larger the energies of DOF i's displacement row are than those of its velocity row; 1 where they share
// nothing.
Scaled displacement_ratio(const EquationList& list, const BatchTable& table, int dof) {
  Scaled largest;
  for (int n = table.layout.first[dof]; n < table.layout.first[dof + 1]; ++n) {
    const Scaled velocity = column_square(table, list.equation[dof].weight, n);
    if (velocity.is_zero()) continue;
    const Scaled ratio = sqrt(column_square(table, Weight::kDisplacement, n) / velocity);
    if (ratio > largest) largest = ratio;
  }
  return largest.is_zero() ? Scaled::from_int(1) : largest;
}

}  // namespace

LevelObservables& WeightedFit::load_level(int level) {
  if (level != loaded_) level_.load(*list_, table_->layout, table_->level[level]);
  loaded_ = level;
  return level_;
}

void WeightedFit::start_weights() {
  for (int e = 0; e < list_->count; ++e)
    relative_deviation_[e] =
        e < list_->dof_count ? Scaled::from_int(1) : displacement_ratio(*list_, *table_, e - list_->dof_count);
  for (int l = 0; l < table_->level_count; ++l)
    for (int e = 0; e < list_->count; ++e) whitening_[l][e] = Whitening{};
}

// A level too short to show scatter takes it from the others, in proportion to its motion energy (the noise of a sensor
// that is a fixed share of the signal), else keeps the start weight.
void WeightedFit::fill_unmeasured() {
  all_measured_ = true;
  for (int l = table_->level_count - 1; l >= 0; --l) {  // ends with the level that the fit begins with
    const LevelObservables& level = load_level(l);
    for (int e = 0; e < list_->count; ++e) {
      Whitening& whitening = whitening_[l][e];
      if (whitening.measured) continue;
      const int dof = list_->equation[e].dof;
      const Scaled mean = level.motion_mean(dof);
      const Scaled motion = level.periodic() ? level.motion_total(dof) * mean : mean;
      whitening.deviation = relative_deviation_[e] * sqrt(motion);
      if (level.rows_used(dof) > 0) all_measured_ = false;
    }
  }
}

void WeightedFit::measure_weights() {
  Scaled sum[kMaxEquations], noise;
  int count[kMaxEquations] = {}, noise_count = 0;
  for (int l = 0; l < table_->level_count; ++l) {
    LevelObservables& level = load_level(l);
    level.set_residuals(parameters_);
    for (int e = 0; e < list_->count; ++e) {
      Whitening& whitening = whitening_[l][e] = measure_whitening(*list_, level, e);
      if (!whitening.measured) continue;
      noise = noise + whitening.relative_noise_square;
      ++noise_count;
      const int dof = list_->equation[e].dof;
      const Scaled mean = level.motion_mean(dof);
      const Scaled motion = level.periodic() ? level.motion_total(dof) * mean : mean;
      if (motion.is_zero()) continue;
      sum[e] = sum[e] + whitening.deviation * whitening.deviation / motion;
      ++count[e];
    }
  }
  relative_noise_ = noise_count ? sqrt(noise / Scaled::from_int(noise_count)) : Scaled{};
  for (int e = 0; e < list_->count; ++e)
    if (count[e] > 0) relative_deviation_[e] = sqrt(sum[e] / Scaled::from_int(count[e]));
}

void WeightedFit::fit() {
  factor_.clear(list_->unknown_count);
  Row row;
  for (int l = 0; l < table_->level_count; ++l) {
    const LevelObservables& level = load_level(l);
    const int first = level.periodic() ? -1 : 0, last = level.periodic() ? 0 : level.batch_count();
    for (int e = 0; e < list_->count; ++e)
      for (int b = first; b < last; ++b)
        if (whitened_row(*list_, level, whitening_[l][e], e, b, row)) factor_.add(row);
  }
  factor_.solve(parameters_);
}

void WeightedFit::solve(const EquationList& list, const BatchTable& table) {
  list_ = &list;
  table_ = &table;
  loaded_ = -1;
  start_weights();
  fill_unmeasured();
  fit();
  judge_identifiability(factor_, parameters_, identifiability_);
  for (int pass = 0; pass < kReweightings; ++pass) {
    measure_weights();
    fill_unmeasured();
    fit();
  }
  factor_.invert();
}

}  // namespace firmware
