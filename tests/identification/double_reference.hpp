// The same estimator in double precision with Eigen, written from its description (docs/estimation.md), not from the
// core.
#pragma once
#include <Eigen/Dense>

#include "firmware/configuration/configuration.hpp"
#include "firmware/energy/batch_table.hpp"

namespace reference {

struct Result {
  Eigen::VectorXd value, deviation;
};

// Tables with an instrument, velocity rows only, all levels long enough to show their own scatter.
Result estimate(const firmware::CoreConfiguration& configuration, const firmware::BatchTable& table);

}  // namespace reference
