// Least squares over the energy equations of all DOFs and levels (Eq. 20 to 22), weighted by their measured scatter.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "firmware/energy/batch_table.hpp"
#include "firmware/identification/estimate.hpp"
#include "firmware/identification/fit/weighted_fit.hpp"
#include "firmware/identification/intervals/bias_check.hpp"
#include "firmware/identification/intervals/uncertainty.hpp"

namespace firmware {

// What one solve works on and forgets: 333 KB with the full table, each estimator's own.
struct IdentificationMemory {
  WeightedFit fit;
  BiasCheck bias;
  UncertaintySums sums;
};

bool any_batch(const BatchTable& table);
// Reads the table, writes estimates.
void identify(const CoreConfiguration& configuration, const BatchTable& table, IdentificationMemory& memory,
              Estimates& estimates);

}  // namespace firmware
