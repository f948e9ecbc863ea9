// Weights of the energy equations from their measured scatter: generalised least squares, one equation after the other.
//
// The row of equation e is replaced by  row_e - sum_j b_j observable_j,  divided by the standard deviation of what
// remains. The observables j are the discrepancies of its own and neighbouring DOFs (no columns, zero mean) and the
// rows of neighbouring equations that come before it; b is their regression on the scatter of the level's batches. This
// is the modified Cholesky form of the full covariance, cut to neighbours in the rig: only those share sensor noise.
#pragma once
#include "firmware/identification/level_observables.hpp"

namespace firmware {

constexpr int kLeastBatches = 4;           // fewer show no usable scatter
constexpr int kBatchesPerCoefficient = 7;  // regression coefficients are limited to batches / 7
constexpr int kMostCoefficients = (kMaxBatches - 1) / kBatchesPerCoefficient;
constexpr int kMaxPredecessors = kMostCoefficients < 1 ? 1 : kMostCoefficients < 12 ? kMostCoefficients : 12;

struct Whitening {
  bool measured = false;  // deviation is from this level's own scatter
  uint8_t count = 0;
  uint8_t observable[kMaxPredecessors] = {};
  Scaled coefficient[kMaxPredecessors];
  Scaled deviation;              // standard deviation of the reduced row; 0: the row is not used
  int16_t freedom = 0;           // degrees of freedom of deviation
  Scaled inflation;              // variance factor for regression coefficients that are themselves estimated
  Scaled relative_noise_square;  // (deviation of one unreduced row / its energy)^2
};

Whitening measure_whitening(const EquationList& list, const LevelObservables& level, int e);
// Row of batch b (or, with b < 0, of the whole periodic level), reduced and divided by its deviation.
// Returns false when it is not to be used.
bool whitened_row(const EquationList& list, const LevelObservables& level, const Whitening& whitening, int e, int batch,
                  Row& row);

}  // namespace firmware
