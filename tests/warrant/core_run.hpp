// A hidden rig's records through the fixed-point core, as the board would take them.
#pragma once
#include <memory>

#include "draw.hpp"
#include "firmware/estimator_core.hpp"

namespace warrant_test {

struct CoreRun {
  firmware::CoreConfiguration configuration;
  std::unique_ptr<firmware::EstimatorCore> core;  // after solve()
};

// budget: probe_products_per_sample.
CoreRun run_core(const hidden_rig::Draw& draw, uint16_t budget = firmware::kAllProbes);

}  // namespace warrant_test
