// What one level shows of its noise: the residual of every energy equation in every batch, and the kinematic
// discrepancies, which are zero for any rig and so show noise alone (control variates of the equations).
//
// Periodic levels (one long row per equation): batches are equal repetitions; their deviations from the mean show the
// noise, the row itself is the sum over the batches. Where batches are whole cycles the discrepancy without its end
// points has the smaller scatter (the end-point noise of neighbouring batches cancels in the sum), so that form is used
// for covariances. Other levels: every batch is a row, divided by sqrt(integral of v^2) of its DOF: white sensor noise
// times the weight v.
#pragma once
#include "firmware/identification/rows.hpp"

namespace firmware {

constexpr int kControlsPerDof =
    kWeights;  // kinetic and elastic of the velocity weight, kinetic of the displacement weight
constexpr int kMaxControls = kControlsPerDof * kMaxDofs;
constexpr int kMaxObservables = kMaxControls + kMaxEquations;

class LevelObservables {
 public:
  // Reads the discrepancies and the scale of every batch. The level must outlive the object's use.
  void load(const EquationList& list, const RowLayout& layout, const Level& level);
  void set_residuals(const Scaled* parameters);
  // Sum of squares of all energies of the equation's rows, as of set_residuals.
  Scaled energy_square(int e) const { return energy_square_[e]; }
  // Sums of squares up to this are rounding, not scatter: (2^-35 of the energy)^2.
  Scaled rounding_square(int e) const { return scale_by_power_of_two(energy_square_[e], -70); }
  bool scatters(int e) const { return scatters_[e]; }  // the residuals do, beyond rounding

  bool periodic() const { return level_->periodic; }
  int batch_count() const { return level_->batch_count; }
  bool row_used(int batch, int dof) const { return used_[batch][dof]; }  // the DOF moves in this batch
  int rows_used(int dof) const { return rows_used_[dof]; }

  static int control(int dof, int which) { return kControlsPerDof * dof + which; }
  static int equation(int e) { return kMaxControls + e; }
  // Measured, and its mean is zero as far as its scatter can tell.
  bool control_valid(int c) const { return valid_[c]; }
  Scaled deviation(int observable, int batch) const { return deviation_[observable][batch]; }
  // Of the level's own two end points, left out of deviation.
  Scaled end_variance(int c) const { return end_variance_[c]; }
  Scaled total(int c) const { return total_[c]; }  // periodic levels: sum over the batches, ends included

  Scaled inverse_scale(int batch, int dof) const { return inverse_scale_[batch][dof]; }  // 1 in periodic levels

  // Row of one batch (divided by sqrt(V)), or of the whole periodic level.
  void row(int e, int batch, Row& row) const;
  void level_row(int e, Row& row) const;
  Scaled motion_mean(int dof) const { return motion_mean_[dof]; }  // mean over batches of V = integral of v^2
  Scaled motion_total(int dof) const { return motion_total_[dof]; }

 private:
  void load_scale(int dof);
  void load_control(int dof, int which);
  void judge_control(int c);
  Scaled sum_energy_square(int e, const Scaled* parameters) const;

  const EquationList* list_ = nullptr;
  const RowLayout* layout_ = nullptr;
  const Level* level_ = nullptr;
  bool used_[kMaxBatches][kMaxDofs];
  int rows_used_[kMaxDofs];
  bool valid_[kMaxControls];
  Scaled inverse_scale_[kMaxBatches][kMaxDofs];
  Scaled deviation_[kMaxObservables][kMaxBatches];
  Scaled end_variance_[kMaxControls];
  Scaled total_[kMaxControls];
  Scaled energy_square_[kMaxEquations];
  bool scatters_[kMaxEquations];
  Scaled motion_mean_[kMaxDofs], motion_total_[kMaxDofs];
};

}  // namespace firmware
