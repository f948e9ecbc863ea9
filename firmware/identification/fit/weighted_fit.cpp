#include "firmware/identification/fit/weighted_fit.hpp"

namespace firmware {
namespace {

constexpr int kReweightings = 2;

Scaled column_square(const BatchTable& table, Weight weight, int n) {
  Scaled sum;
  for (int l = 0; l < table.level_count; ++l)
    for (int b = 0; b < table.level[l].batch_count; ++b) {
      const Scaled value = unpack(table.level[l].batch[b].column[static_cast<int>(weight)][n]);
      sum += value * value;
    }
  return sum;
}

// How much larger the energies of DOF i's displacement row are than those of its velocity row, each over the root of the integral
// of its weight squared; 1 where they share nothing.
Scaled displacement_ratio(const EquationList& list, const BatchTable& table, int dof) {
  Scaled largest;
  for (int n = table.layout.first[dof]; n < table.layout.first[dof + 1]; ++n) {
    const Scaled velocity = column_square(table, list.equation[dof].weight, n);
    if (velocity.is_zero()) continue;
    keep_larger(largest, sqrt(column_square(table, Weight::kDisplacement, n) / velocity));
  }
  return largest.is_zero() ? kScaledOne : largest / sqrt(displacement_share(table.level, table.level_count, dof));
}

}  // namespace

LevelColumns& WeightedFit::load_level(int level, bool with_controls) {
  level_.load(*list_, table_->layout, table_->level[level], parameters_, with_controls);
  return level_;
}

ReducedRows& WeightedFit::reduce(const Whitening& whitening, int e, bool with_controls) {
  reduce_rows(*list_, level_, whitening, e, with_controls, reduced_);
  return reduced_;
}

void WeightedFit::start_weights() {
  for (int e = 0; e < list_->count; ++e)
    relative_deviation_[e] =
        kWeights < 3 || e < list_->dof_count ? kScaledOne : displacement_ratio(*list_, *table_, e - list_->dof_count);
  for (int l = 0; l < table_->level_count; ++l)
    for (int e = 0; e < list_->count; ++e) whitening_[l][e] = Whitening{};
  for (int k = 0; k < list_->unknown_count; ++k) parameters_[k] = Scaled{};
  relative_noise_ = Scaled{};
}

// What a row's square is in proportion to, in the level that is loaded.
Scaled WeightedFit::motion_of(int e) const {
  const int dof = list_->equation[e].dof;
  const Scaled& mean = level_.motion_mean(dof);
  return level_.periodic() ? level_.motion_total(dof) * mean * level_.weight_share(e) : mean;
}

// Weights of the equations whose scatter the level shows.
void WeightedFit::measure_level(int l) {
  for (int e = 0; e < list_->count; ++e) {
    Scaled relative_noise_square;
    Whitening& whitening = whitening_[l][e] = measure_whitening(*list_, level_, e, relative_noise_square);
    if (!whitening.measured) continue;
    noise_sum_ += relative_noise_square;
    ++noise_count_;
    const Scaled motion = motion_of(e);
    if (motion.is_zero()) continue;
    deviation_sum_[e] += whitening.deviation * whitening.deviation / motion;
    ++deviation_count_[e];
  }
}

// A level too short to show scatter takes it from the others, in proportion to its motion energy (the noise of a sensor
// that is a fixed share of the signal), else keeps the start weight. An equation that no level shows the scatter of, beside others
// that do, has no weight to compare with theirs: it is left out.
void WeightedFit::take_unmeasured(int l) {
  for (int e = 0; e < list_->count; ++e) {
    Whitening& whitening = whitening_[l][e];
    if (whitening.measured) continue;
    whitening.deviation = relative_deviation_[e] * sqrt(motion_of(e));
    if (level_.rows_used(e) > 0 && !whitening.deviation.is_zero()) all_measured_ = false;
    add_equation(l, e);
  }
}

void WeightedFit::add_equation(int l, int e) {
  const Whitening& whitening = whitening_[l][e];
  if (whitening.deviation.is_zero()) return;
  if (level_.periodic()) {
    Row row;
    if (!whitened_level_row(*list_, level_, whitening, e, row)) return;
    return new_equations_ ? equations_.add(row) : equations_.add_right_side(row);
  }
  const ReducedRows& rows = reduce(whitening, e, true);
  const int n = level_.batch_count();
  const Scaled weight = whitening.weight();
  for (int j = 0; j < rows.unknowns; ++j) {
    for (int i = 0; new_equations_ && i <= j; ++i)
      equations_.add_product(rows.unknown[i], rows.unknown[j], dot(rows.column(i), rows.column(j), n) * weight);
    equations_.add_moment(rows.unknown[j], dot(rows.column(j), rows.residual(), n) * weight);
  }
  equations_.add_square(dot(rows.residual(), rows.residual(), n) * weight);
}

void WeightedFit::begin_pass(bool new_equations) {
  new_equations_ = new_equations;
  new_equations ? equations_.clear(list_->unknown_count) : equations_.clear_right_side();
  all_measured_ = true;
  noise_sum_ = Scaled{};
  noise_count_ = 0;
  for (int e = 0; e < list_->count; ++e) {
    deviation_sum_[e] = Scaled{};
    deviation_count_[e] = 0;
  }
}

void WeightedFit::end_pass() {
  if (new_equations_) equations_.factorise();
  equations_.substitute();
  Scaled change[kMaxUnknowns];
  equations_.solve(change);
  for (int k = 0; k < list_->unknown_count; ++k) parameters_[k] += change[k];
}

void WeightedFit::start_pass(bool new_equations) {
  begin_pass(new_equations);
  for (int l = 0; l < table_->level_count; ++l) {
    load_level(l, false);
    take_unmeasured(l);
  }
  end_pass();
}

// Levels that show no scatter of their own come last: what they take from the others is known then.
void WeightedFit::weighted_pass() {
  begin_pass(true);
  bool missing[kMaxLevels] = {};
  for (int l = 0; l < table_->level_count; ++l) {
    load_level(l);
    measure_level(l);
    for (int e = 0; e < list_->count; ++e)
      whitening_[l][e].measured ? add_equation(l, e) : static_cast<void>(missing[l] = true);
  }
  relative_noise_ = noise_count_ ? sqrt(noise_sum_ / noise_count_) : Scaled{};
  for (int e = 0; e < list_->count; ++e) {
    if (deviation_count_[e] > 0)
      relative_deviation_[e] = sqrt(deviation_sum_[e] / deviation_count_[e]);
    else if (noise_count_ > 0)
      relative_deviation_[e] = Scaled{};
  }
  for (int l = 0; l < table_->level_count; ++l) {
    if (!missing[l]) continue;
    load_level(l);
    take_unmeasured(l);
  }
  end_pass();
}

void WeightedFit::solve(const EquationList& list, const BatchTable& table) {
  list_ = &list;
  table_ = &table;
  start_weights();
  start_pass(true);
  start_pass(false);
  judge_identifiability(equations_, parameters_, identifiability_);
  for (int pass = 0; pass < kReweightings; ++pass) weighted_pass();
  equations_.invert();
}

}  // namespace firmware
