// One level as columns of whole numbers, a number to each batch and an exponent to each column: the terms of every
// energy equation and its residual, and the kinematic discrepancies, which are zero for any rig and so show noise alone
// (control variates of the equations). Sums over batches of products of two columns are exact.
//
// Periodic levels (one long row per equation): batches are equal repetitions; their deviations from the mean show the
// noise, the row itself is the sum over the batches. Where batches are whole cycles the discrepancy without its end
// points has the smaller scatter (the end-point noise of neighbouring batches cancels in the sum), so that form is used
// for covariances. Other levels: every batch is a row, divided by what white noise of its equation scatters it in proportion to: the
// root of the integral of its weight squared (to 2^-28: all that stands in the row by the same number). Where a batch is shorter
// than a period, the weights v and x of a DOF are no longer orthogonal in it, and noise scatters both rows together, with one sign
// or the other. So the displacement row is taken with the part of x that is orthogonal to v in this batch,
//   x - v (integral of x v) / (integral of v^2)
// A batch that leaves less than 2^-kLeastShareLog2 of the integral of x^2 has no displacement row.
//
// Formats: kColumnBits for the largest number of a column (27 for 128 batches: 2^-28 of it is what rounding costs the
// others), products below 2^54, their sums below 2^62. Residuals are formed before they are rounded, so that they have
// their own exponent.
#pragma once
#include "firmware/fixed_point/whole_column.hpp"
#include "firmware/identification/rows/rows.hpp"

namespace firmware {

constexpr int kControlsPerDof =
    kWeights;  // kinetic and elastic of the velocity weight, kinetic of the displacement weight
constexpr int kMaxControls = kControlsPerDof * kMaxDofs;
// An equation is reduced by others and by controls with one coefficient for so many batches. A table of fewer has none to reduce by:
// what serves that is then left out of the image.
constexpr int kBatchesPerCoefficient = 7;
constexpr int kMostCoefficients = (kMaxBatches - 1) / kBatchesPerCoefficient;
constexpr bool kReduces = kMostCoefficients > 0;
constexpr int kMaxObservables = kMaxControls + kMaxEquations;
constexpr int kLevelColumns = kMaxObservables + (kWeights - 1) * kMaxIncidences;

constexpr int bits_of(int count) { return count <= 1 ? 0 : 1 + bits_of((count + 1) / 2); }
constexpr int kColumnBits = (62 - bits_of(kMaxBatches)) / 2;
static_assert(kColumnBits <= 30, "a column's numbers have 32 bits");

class LevelColumns {
 public:
  // Fills everything, but the controls only where they are wanted. The level must outlive the object's use.
  void load(const EquationList& list, const RowLayout& layout, const Level& level, const Scaled* parameters,
            bool with_controls);
  // In place of the residuals: change(batch, e), in J.
  template <typename Change>
  void load_changes(Change change) {
    for (int e = 0; e < list_->count; ++e) {
      load_row_scale(e);
      for (int b = 0; b < batch_count(); ++b) number_[b] = scaled(b, e, change);
      round(residual(e));
    }
  }

  bool periodic() const { return level_->periodic; }
  int batch_count() const { return level_->batch_count; }
  bool row_used(int batch, int dof) const { return used_[batch][dof]; }  // the DOF moves in this batch
  int rows_used(int e) const { return rows_used_[e]; }

  // Places of columns. Observables are controls and residuals.
  static int control(int dof, int which) { return kControlsPerDof * dof + which; }
  static int residual(int e) { return kMaxControls + e; }
  // n: as in RowLayout::unknown.
  int term(int e, int n) const { return kMaxObservables + (e < list_->dof_count ? 0 : kMaxIncidences) + n; }
  WholeColumn column(int place) const { return {value_[place], exponent_[place]}; }
  Scaled product(int place, int other) const { return dot(column(place), column(other), batch_count()); }
  int first_term(int e) const { return layout_->first[list_->equation[e].dof]; }
  int behind_terms(int e) const { return layout_->first[list_->equation[e].dof + 1]; }
  int unknown_of(int n) const { return layout_->unknown[n]; }

  // Sum of squares of all energies of the equation's rows.
  const Scaled& energy_square(int e) const { return energy_square_[e]; }
  // Sums of squares up to this are rounding, not scatter: (2^-35 of the energy)^2.
  Scaled rounding_square(int e) const { return scale_by_power_of_two(energy_square_[e], -70); }
  bool scatters(int e) const { return scatters_[e]; }  // the residuals do, beyond rounding
  // Measured, and its mean is zero as far as its scatter can tell.
  bool control_valid(int c) const { return valid_[c]; }
  // Of the level's own two end points, left out of the control's column.
  const Scaled& end_variance(int c) const { return end_variance_[c]; }

  // Periodic levels: sums over the batches. row: of all terms, its right-hand side the residual.
  const Scaled& total(int observable) const { return total_[observable]; }
  void level_row(int e, Row& row) const;

  const Scaled& motion_mean(int dof) const { return motion_mean_[dof]; }  // mean over batches of V = integral of v^2
  const Scaled& motion_total(int dof) const { return motion_total_[dof]; }
  // Integral of the equation's weight squared in proportion to that of v^2, over the level; 1 for velocity rows.
  Scaled weight_share(int e) const;

 private:
  bool displacement_row(int e) const { return kWeights > 2 && e >= list_->dof_count; }
  // What value(batch, equation) gives to the row of equation e.
  template <typename Value>
  Scaled scaled(int b, int e, const Value& value) const {
    const Batch& batch = level_->batch[b];
    Scaled number = value(batch, e);
    if (level_->periodic) return number;
    if (!displacement_row(e)) {
      number *= inverse_scale_[b][list_->equation[e].dof];
    } else {
      number *= displacement_scale_[b];
      multiply_subtract(number, other_[b], value(batch, e - list_->dof_count));
    }
    return number;
  }
  void load_scale(int dof);
  void load_row_scale(int e);
  void load_control(int dof, int which);
  void judge_control(int c);
  void load_equation(int e, const Scaled* parameters);
  void round(int place) { exponent_[place] = round_to_column(number_, batch_count(), kColumnBits, value_[place]); }
  Scaled square(int place) const { return product(place, place); }

  const EquationList* list_ = nullptr;
  const RowLayout* layout_ = nullptr;
  const Level* level_ = nullptr;
  bool used_[kMaxBatches][kMaxDofs];
  uint16_t rows_used_[kMaxEquations];
  bool valid_[kMaxControls];
  bool scatters_[kMaxEquations];
  Scaled inverse_scale_[kMaxBatches][kMaxDofs];  // 1 in periodic levels
  int32_t value_[kLevelColumns][kMaxBatches];
  int32_t exponent_[kLevelColumns];
  Scaled end_variance_[kMaxControls];
  Scaled total_[kMaxObservables];
  Scaled energy_square_[kMaxEquations];
  Scaled motion_mean_[kMaxDofs], motion_total_[kMaxDofs];
  // Before they are rounded; of a periodic level the same with its ends. Of the displacement row that is being loaded of another level:
  // how much of the velocity row is taken off, and what it is multiplied by before.
  Scaled number_[kMaxBatches], other_[kMaxBatches];
  Scaled displacement_scale_[kWeights > 2 ? kMaxBatches : 1];
};

}  // namespace firmware
