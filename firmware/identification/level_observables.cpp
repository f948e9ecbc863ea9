#include "firmware/identification/level_observables.hpp"

namespace firmware {
namespace {

constexpr int kSystematicDeviations = 4;  // a control variate whose mean is this far from zero is not noise

void remove_mean(Scaled* values, int count) {
  Scaled sum;
  for (int b = 0; b < count; ++b) sum = sum + values[b];
  const Scaled mean = sum / Scaled::from_int(count);
  for (int b = 0; b < count; ++b) values[b] = values[b] - mean;
}

Scaled sum_of_squares(const Scaled* values, int count) {
  Scaled sum;
  for (int b = 0; b < count; ++b) sum = sum + values[b] * values[b];
  return sum;
}

// Integral of v^2 over the samples that the velocity row counts (all, or those with clear signs of friction).
Scaled weighted_motion(const BatchDof& batch, bool instrument) {
  const Scaled motion = unpack(batch.velocity_square);
  if (!instrument || batch.weight_square.bits == batch.velocity_instrument.bits) return motion;
  const Scaled counted = unpack(batch.weight_square), all = unpack(batch.velocity_instrument);
  return counted > Scaled{} && all > Scaled{} ? motion * counted / all : Scaled{};
}

}  // namespace

void LevelObservables::load(const EquationList& list, const RowLayout& layout, const Level& level) {
  list_ = &list;
  layout_ = &layout;
  level_ = &level;
  for (int i = 0; i < list.dof_count; ++i) {
    load_scale(i);
    for (int which = 0; which < (list.displacement ? kControlsPerDof : 2); ++which) {
      load_control(i, which);
      judge_control(control(i, which));
    }
  }
}

void LevelObservables::load_scale(int dof) {
  const int n = level_->batch_count;
  Scaled sum;
  for (int b = 0; b < n; ++b) sum = sum + unpack(level_->batch[b].dof[dof].velocity_square);
  motion_total_[dof] = sum;
  motion_mean_[dof] = n ? sum / Scaled::from_int(n) : Scaled{};
  rows_used_[dof] = 0;
  for (int b = 0; b < n; ++b) {
    const BatchDof& batch = level_->batch[b].dof[dof];
    const Scaled motion = weighted_motion(batch, list_->instrument);
    used_[b][dof] = level_->periodic || (moves(batch, list_->instrument, motion_mean_[dof]) && !motion.is_zero());
    if (used_[b][dof] && !motion.is_zero()) ++rows_used_[dof];
    inverse_scale_[b][dof] = level_->periodic ? Scaled::from_int(1) : Scaled{};
    if (!level_->periodic && used_[b][dof]) inverse_scale_[b][dof] = Scaled::from_int(1) / sqrt(motion);
  }
}

void LevelObservables::load_control(int dof, int which) {
  const int c = control(dof, which), n = level_->batch_count;
  const int q = static_cast<int>(which == 2 ? Weight::kDisplacement : list_->equation[dof].weight);
  Scaled without_ends[kMaxBatches];
  total_[c] = end_variance_[c] = Scaled{};
  for (int b = 0; b < n; ++b) {
    const BatchDof& batch = level_->batch[b].dof[dof];
    const Scaled value = unpack(which == 1 ? batch.elastic_discrepancy[q] : batch.kinetic_discrepancy[q]);
    const Scaled ends = which == 2 ? Scaled{} : unpack(which == 1 ? batch.elastic_end : batch.kinetic_end);
    deviation_[c][b] = value * inverse_scale_[b][dof];
    without_ends[b] = value + ends;
    total_[c] = total_[c] + value;
  }
  if (!level_->periodic || n < 2 || which == 2) return;
  remove_mean(deviation_[c], n);
  remove_mean(without_ends, n);
  const Scaled with = sum_of_squares(deviation_[c], n), without = sum_of_squares(without_ends, n);
  if (total_[c].is_zero() || !(without < with)) return;
  end_variance_[c] = (with - without) / Scaled::from_int(n - 1);
  for (int b = 0; b < n; ++b) deviation_[c][b] = without_ends[b];
}

// Noise alone has a sum whose square is about the sum of squares; more says that the discrepancy has a cause: skew
// between channels, or an acceleration that jumps inside a sample interval at the same place of every cycle.
void LevelObservables::judge_control(int c) {
  const int n = level_->batch_count;
  Scaled sum, squares = sum_of_squares(deviation_[c], n);
  for (int b = 0; b < n; ++b) sum = sum + deviation_[c][b];
  if (level_->periodic) {
    sum = total_[c];
    squares = squares + end_variance_[c];
  }
  valid_[c] =
      !squares.is_zero() && sum * sum < Scaled::from_int(kSystematicDeviations * kSystematicDeviations) * squares;
}

void LevelObservables::set_residuals(const Scaled* parameters) {
  for (int e = 0; e < list_->count; ++e) {
    const int dof = list_->equation[e].dof;
    Scaled* values = deviation_[equation(e)];
    for (int b = 0; b < level_->batch_count; ++b)
      values[b] = inverse_scale_[b][dof] * batch_residual(*layout_, level_->batch[b], list_->equation[e], parameters);
    if (level_->periodic && level_->batch_count > 1) remove_mean(values, level_->batch_count);
    energy_square_[e] = sum_energy_square(e, parameters);
    scatters_[e] = sum_of_squares(values, level_->batch_count) > rounding_square(e);
  }
}

Scaled LevelObservables::sum_energy_square(int e, const Scaled* parameters) const {
  Scaled sum;
  for (int b = 0; b < level_->batch_count; ++b) {
    Row terms;
    row(e, b, terms);
    sum = sum + terms.rhs * terms.rhs;
    for (int k = 0; k < list_->unknown_count; ++k) {
      const Scaled energy = terms.column[k] * parameters[k];
      sum = sum + energy * energy;
    }
  }
  return sum;
}

void LevelObservables::row(int e, int batch, Row& row) const {
  clear_row(list_->unknown_count, row);
  const Equation& equation = list_->equation[e];
  add_batch_row(*layout_, level_->batch[batch], equation, inverse_scale_[batch][equation.dof], row);
}

void LevelObservables::level_row(int e, Row& row) const {
  clear_row(list_->unknown_count, row);
  for (int b = 0; b < level_->batch_count; ++b)
    add_batch_row(*layout_, level_->batch[b], list_->equation[e], Scaled::from_int(1), row);
}

}  // namespace firmware
