// The same estimator in double precision with Eigen, written from its description (docs/estimation.md), not from the
// core.
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "firmware/configuration/configuration.hpp"
#include "firmware/energy/batch_table.hpp"

namespace reference {

// One level: for each batch (rows of the matrices) and DOF (columns), under the instrument's weight. In SI units.
struct LevelEnergies {
  bool periodic = false;
  Eigen::MatrixXd rhs, kinetic, elastic, kinetic_end, elastic_end, motion, clean, counted;
  std::vector<Eigen::MatrixXd> columns;  // per DOF: batches x unknowns

  LevelEnergies(bool periodic, Eigen::Index batches, int dofs, int unknowns);
};

struct Result {
  Eigen::VectorXd value, deviation;
};

// Velocity rows only, all levels long enough to show their own scatter.
Result estimate(const firmware::CoreConfiguration& configuration, const std::vector<LevelEnergies>& levels);
// The same from a table with an instrument.
Result estimate(const firmware::CoreConfiguration& configuration, const firmware::BatchTable& table);

}  // namespace reference
