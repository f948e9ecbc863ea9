#include "firmware/identification/rows/level_columns.hpp"

namespace firmware {
namespace {

constexpr int kSystematicDeviations = 4;  // a control variate whose mean is this far from zero is not noise
// Of the integral of x^2. The difference of two rows that are nearly one has their rounding: 2^-28 of them is 2^-24 of what is left then.
constexpr int kLeastShareLog2 = -8;

void remove_mean(Scaled* values, int count) {
  Scaled sum;
  for (int b = 0; b < count; ++b) sum += values[b];
  const Scaled mean = sum / count;
  for (int b = 0; b < count; ++b) values[b] -= mean;
}

Scaled sum_of_squares(const Scaled* values, int count) {
  Scaled sum;
  for (int b = 0; b < count; ++b) multiply_add(sum, values[b], values[b]);
  return sum;
}

// Integral of v^2 over the samples that the velocity row counts (all, or those with clear signs of friction).
Scaled weighted_motion(const BatchDof& batch, bool instrument) {
  const Scaled motion = unpack(batch.velocity_square);
  if (!instrument || batch.weight_square.bits == batch.velocity_instrument.bits) return motion;
  const Scaled counted = unpack(batch.weight_square), all = unpack(batch.velocity_instrument);
  return counted.is_positive() && all.is_positive() ? motion * counted / all : Scaled{};
}

}  // namespace

void LevelColumns::load(const EquationList& list, const RowLayout& layout, const Level& level, const Scaled* parameters,
                        bool with_controls) {
  list_ = &list;
  layout_ = &layout;
  level_ = &level;
  for (int i = 0; i < list.dof_count; ++i) load_scale(i);
  for (int e = 0; e < list.count; ++e) {
    load_row_scale(e);
    const int first = displacement_row(e) ? 2 : 0, behind = displacement_row(e) ? kControlsPerDof : 2;
    for (int which = first; kReduces && with_controls && which < behind; ++which) {
      load_control(list.equation[e].dof, which);
      judge_control(control(list.equation[e].dof, which));
    }
    load_equation(e, parameters);
  }
}

void LevelColumns::load_scale(int dof) {
  const int n = level_->batch_count;
  Scaled sum;
  for (int b = 0; b < n; ++b) sum += unpack(level_->batch[b].dof[dof].velocity_square);
  motion_total_[dof] = sum;
  motion_mean_[dof] = n ? sum / n : Scaled{};
  const Scaled least = scale_by_power_of_two(motion_mean_[dof], -34);
  rows_used_[dof] = 0;
  for (int b = 0; b < n; ++b) {
    const BatchDof& batch = level_->batch[b].dof[dof];
    const Scaled motion = weighted_motion(batch, list_->instrument);
    used_[b][dof] = level_->periodic || (moves(batch, list_->instrument, least) && !motion.is_zero());
    if (used_[b][dof] && !motion.is_zero()) ++rows_used_[dof];
    inverse_scale_[b][dof] = level_->periodic ? kScaledOne : Scaled{};
    if (!level_->periodic && used_[b][dof]) inverse_scale_[b][dof] = inverse_root(motion);
  }
}

// The integral of x v is known over all samples: those that a friction without a clear sign leaves out have the smallest v.
void LevelColumns::load_row_scale(int e) {
  if (!displacement_row(e)) return;
  const int dof = list_->equation[e].dof;
  rows_used_[e] = level_->periodic ? rows_used_[dof] : 0;
  for (int b = 0; b < batch_count() && !level_->periodic; ++b) {
    displacement_scale_[b] = other_[b] = Scaled{};
    if (inverse_scale_[b][dof].is_zero()) continue;
    const BatchDof& batch = level_->batch[b].dof[dof];
    const Scaled square = unpack(batch.displacement_square());
    const Scaled overlap =
        (unpack(batch.elastic_discrepancy[static_cast<int>(list_->equation[dof].weight)]) + unpack(batch.elastic_end)) *
        inverse_scale_[b][dof];
    const Scaled left = square - overlap * overlap;
    if (left <= scale_by_power_of_two(square, kLeastShareLog2)) continue;
    displacement_scale_[b] = inverse_root(left);
    other_[b] = displacement_scale_[b] * overlap * inverse_scale_[b][dof];
    ++rows_used_[e];
  }
}

Scaled LevelColumns::weight_share(int e) const {
  return displacement_row(e) ? displacement_share(level_, 1, list_->equation[e].dof) : kScaledOne;
}

void LevelColumns::load_control(int dof, int which) {
  const int c = control(dof, which), n = level_->batch_count;
  const auto discrepancy = [&](const Batch& batch, int e) {
    const BatchDof& there = batch.dof[dof];
    const int q = static_cast<int>(list_->equation[e].weight);
    return unpack(which == 1 ? there.elastic_discrepancy[q] : there.kinetic_discrepancy[q]);
  };
  total_[c] = end_variance_[c] = Scaled{};
  for (int b = 0; b < n; ++b) {
    number_[b] = scaled(b, which == 2 ? list_->dof_count + dof : dof, discrepancy);
    if (!level_->periodic) continue;
    const BatchDof& batch = level_->batch[b].dof[dof];
    const Scaled ends = which == 2 ? Scaled{} : unpack(which == 1 ? batch.elastic_end : batch.kinetic_end);
    other_[b] = number_[b] + ends;
    total_[c] += number_[b];
  }
  if (level_->periodic && n > 1 && which != 2) {
    remove_mean(number_, n);
    remove_mean(other_, n);
    const Scaled with = sum_of_squares(number_, n), without = sum_of_squares(other_, n);
    if (!total_[c].is_zero() && without < with) {
      end_variance_[c] = (with - without) / (n - 1);
      for (int b = 0; b < n; ++b) number_[b] = other_[b];
    }
  }
  round(c);
}

// Noise alone has a sum whose square is about the sum of squares; more says that the discrepancy has a cause: skew
// between channels, or an acceleration that jumps inside a sample interval at the same place of every cycle.
void LevelColumns::judge_control(int c) {
  Scaled sum, squares = square(c);
  if (level_->periodic) {
    sum = total_[c];
    squares += end_variance_[c];
  } else {
    int64_t whole = 0;
    for (int b = 0; b < batch_count(); ++b) whole += value_[c][b];
    sum = Scaled::from_int(whole, exponent_[c]);
  }
  valid_[c] =
      !squares.is_zero() && sum * sum < Scaled::from_int(kSystematicDeviations * kSystematicDeviations) * squares;
}

void LevelColumns::load_equation(int e, const Scaled* parameters) {
  const int n = batch_count();
  const auto weight = [&](int equation) { return static_cast<int>(list_->equation[equation].weight); };
  energy_square_[e] = Scaled{};
  for (int k = first_term(e); k < behind_terms(e); ++k) {
    const auto energy = [&](const Batch& batch, int row) { return unpack(batch.column[weight(row)][k]); };
    for (int b = 0; b < n; ++b) number_[b] = scaled(b, e, energy);
    round(term(e, k));
    const Scaled& p = parameters[unknown_of(k)];
    multiply_add(energy_square_[e], square(term(e, k)), p * p);
  }
  const int dof = list_->equation[e].dof;
  const auto right_side = [&](const Batch& batch, int row) { return unpack(batch.dof[dof].rhs[weight(row)]); };
  for (int b = 0; b < n; ++b) number_[b] = scaled(b, e, right_side);
  round(residual(e));  // for its square alone
  energy_square_[e] += square(residual(e));
  Scaled& total = total_[residual(e)];
  total = Scaled{};
  const auto residual_of = [&](const Batch& batch, int row) {
    return batch_residual(*layout_, batch, list_->equation[row], parameters);
  };
  for (int b = 0; b < n; ++b) {
    number_[b] = scaled(b, e, residual_of);
    if (level_->periodic) total += number_[b];
  }
  if (level_->periodic && n > 1) remove_mean(number_, n);
  round(residual(e));
  scatters_[e] = square(residual(e)) > rounding_square(e);
}

void LevelColumns::level_row(int e, Row& row) const {
  clear_row(list_->unknown_count, row);
  for (int b = 0; b < batch_count(); ++b)
    add_batch_row(*layout_, level_->batch[b], list_->equation[e], kScaledOne, row);
  row.rhs = total_[residual(e)];
}

}  // namespace firmware
