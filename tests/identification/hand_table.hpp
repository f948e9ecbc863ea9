// Batch tables written by hand: one DOF or a chain, energies given as plain numbers.
#pragma once
#include <memory>
#include <vector>

#include "firmware/identification/identification.hpp"
#include "hal/rig_file/scaled_double.hpp"

namespace hand {

using firmware::Weight;

// Instrument rows of one DOF in one batch; what is not given is zero.
struct DofEntry {
  std::vector<double> columns;  // in the order of the DOF's unknowns
  double rhs = 0.0;
  double kinetic = 0.0, elastic = 0.0;  // discrepancies
  double motion = 1.0;                  // integral of v^2, all of it free of noise
  double acceleration_square = 0.0;
  double plain_rhs_change = 0.0;  // plain rhs minus instrumented rhs
  double elastic_end = 0.0;       // (x_end^2 - x_start^2) / 2
  struct Displacement {           // row of the displacement weight, and the integral of x^2
    std::vector<double> columns;
    double rhs = 0.0, square = 0.0;
  };
  Displacement displacement = {};
};

class HandTable {
 public:
  // unknown kinds in order; every unknown stands in the equations of the listed DOFs.
  HandTable(int dofs, const std::vector<firmware::TermKind>& kinds,
            const std::vector<std::vector<int>>& dofs_of_unknown);

  void link(int a, int b) {
    configuration.links[configuration.link_count].node_a = static_cast<uint8_t>(a);
    configuration.links[configuration.link_count++].node_b = static_cast<uint8_t>(b);
  }
  void known(firmware::TermKind kind, int place, double value);
  void level(bool periodic);
  void batch(const std::vector<DofEntry>& dofs);
  const firmware::Estimates& identify();

  double value(int k) const { return rig_file::to_double(estimates->parameters[k].value); }
  double deviation(int k) const { return rig_file::to_double(estimates->parameters[k].std); }
  firmware::EstimateStatus status(int k) const { return estimates->parameters[k].status; }

  firmware::CoreConfiguration configuration;
  std::unique_ptr<firmware::BatchTable> table = std::make_unique<firmware::BatchTable>();
  std::unique_ptr<firmware::IdentificationMemory> memory = std::make_unique<firmware::IdentificationMemory>();
  std::unique_ptr<firmware::Estimates> estimates = std::make_unique<firmware::Estimates>();
};

}  // namespace hand
