#include "verdict_counts.hpp"

#include <cmath>

#include "hal/rig_file/scaled_double.hpp"

namespace warrant_test {

using firmware::EstimateStatus;
using rig_file::to_double;

bool is_valid_and_wrong(const hidden_rig::Draw& draw, const firmware::Estimates& estimates, int unknown) {
  const firmware::ParameterEstimate& p = estimates.parameters[unknown];
  const double truth = draw.coefficients[static_cast<size_t>(unknown)].value,
               off = std::abs(to_double(p.value) - truth);
  return p.status == EstimateStatus::kValid && off > 0.05 * std::abs(truth) && off > 4.0 * to_double(p.std);
}

int valid_and_wrong(const hidden_rig::Draw& draw, const firmware::Estimates& estimates) {
  int wrong = 0;
  for (int k = 0; k < estimates.unknown_count; ++k) wrong += is_valid_and_wrong(draw, estimates, k);
  return wrong;
}

bool suspect(const firmware::Estimates& estimates) {
  for (int k = 0; k < estimates.unknown_count; ++k)
    if (estimates.parameters[k].status == EstimateStatus::kModelSuspect) return true;
  return false;
}

}  // namespace warrant_test
