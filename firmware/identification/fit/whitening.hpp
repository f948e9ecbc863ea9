// Weights of the energy equations from their measured scatter: generalised least squares, one equation after the other.
//
// The row of equation e is replaced by  row_e - sum_j b_j observable_j,  divided by the standard deviation of what
// remains. The observables j are the discrepancies of its own and neighbouring DOFs (no columns, zero mean) and the
// rows of neighbouring equations that come before it; b is their regression on the scatter of the level's batches. This
// is the modified Cholesky form of the full covariance, cut to neighbours in the rig: only those share sensor noise.
#pragma once
#include "firmware/identification/fit/normal_equations.hpp"
#include "firmware/identification/rows/level_columns.hpp"

namespace firmware {

constexpr int kLeastBatches = 4;  // fewer show no usable scatter
constexpr int kMaxPredecessors = kMostCoefficients < 1 ? 1 : kMostCoefficients < 12 ? kMostCoefficients : 12;

struct Whitening {
  bool measured = false;  // deviation is from this level's own scatter
  uint8_t count = 0;
  int coefficients() const { return kReduces ? count : 0; }
  uint8_t observable[kMaxPredecessors] = {};
  Scaled coefficient[kMaxPredecessors];
  Scaled deviation;       // standard deviation of the reduced row; 0: the row is not used
  int16_t freedom = 0;    // degrees of freedom of deviation
  Scaled inflation;       // variance factor for regression coefficients that are themselves estimated
  Scaled weight() const;  // 1 / variance, where the row is used
};

// relative_noise_square: where it is measured, (deviation of one unreduced row / its energy)^2.
Whitening measure_whitening(const EquationList& list, const LevelColumns& level, int e, Scaled& relative_noise_square);

// Working memory: the reduced rows of one equation of a level, column by column, not yet divided by their deviation.
struct ReducedRows {
  int rows = 0;      // that count; the others are zero
  int unknowns = 0;  // columns: the equation's own unknowns and those of the equations it is reduced by
  uint8_t unknown[kMaxUnknowns];
  int32_t value[kMaxUnknowns + 2][kMaxBatches];  // columns, then residuals, then room for one more
  int32_t exponent[kMaxUnknowns + 2];
  WholeColumn column(int k) const { return {value[k], exponent[k]}; }
  WholeColumn residual() const { return column(unknowns); }
  // One row of all unknowns; its right-hand side is the residual.
  void read(int batch, int unknown_count, Row& row) const;
  // In the free column: sum of factor[k] column[k].
  WholeColumn combine(const Scaled* factor, int count);
};

// The rows of a level that is not periodic; with_controls false: without the discrepancies.
void reduce_rows(const EquationList& list, const LevelColumns& level, const Whitening& whitening, int e,
                 bool with_controls, ReducedRows& reduced);
// The one row of a periodic level, reduced and divided by its deviation; its right-hand side is the residual. False
// where it is not to be used.
bool whitened_level_row(const EquationList& list, const LevelColumns& level, const Whitening& whitening, int e,
                        Row& row);

}  // namespace firmware
