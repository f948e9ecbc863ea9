// The energy equations as rows over all unknowns, read from the batch table.
//
// One equation per DOF with the velocity weight (the instrument where the table holds one, else the plain velocity),
// and a second one with the displacement weight where a mass, a stiffness or another conservative coefficient is
// unknown: over whole cycles velocity-weighted rows do not see those.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "firmware/energy/batch_table.hpp"

namespace firmware {

struct Equation {
  uint8_t dof = 0;
  Weight weight = Weight::kPlain;
};
constexpr int kMaxEquations = (kWeights - 1) * kMaxDofs;

struct EquationList {
  uint8_t count = 0;
  uint8_t dof_count = 0;
  uint8_t unknown_count = 0;
  bool instrument = false;    // the velocity rows use the instrument
  bool displacement = false;  // there are displacement rows: equation[dof_count + i]
  Equation equation[kMaxEquations];
  uint32_t neighbours[kMaxDofs] = {};  // bit j: a link joins DOFs i and j, or i == j
  // Bits of the DOF's discrepancies (kinetic, elastic, kinetic of the displacement) among signals of one channel: they show no noise
  // of its own, only what the filter that made one of the other misses, and that goes with the motion.
  uint8_t of_one_channel[kDerivesSignals ? kMaxDofs : 1] = {};

  bool shows_noise(int dof, int which) const {
    return !kDerivesSignals || (of_one_channel[kDerivesSignals ? dof : 0] >> which & 1) == 0;
  }
};

// sum over unknowns of column * p = rhs, energies in J.
struct Row {
  Scaled column[kMaxUnknowns];
  Scaled rhs;
};

bool stands_in(const RowLayout& layout, int dof, int unknown);  // whether the DOF's equations have the unknown
bool is_conservative(TermKind kind);                            // its work over a closed cycle is zero
EquationList list_equations(const CoreConfiguration& configuration, const BatchTable& table);

void clear_row(int unknowns, Row& row);
// row += factor * the equation's row of one batch.
void add_batch_row(const RowLayout& layout, const Batch& batch, Equation equation, const Scaled& factor, Row& row);
// rhs - sum of column * p of one batch.
Scaled batch_residual(const RowLayout& layout, const Batch& batch, Equation equation, const Scaled* parameters);
// Integral of x^2 over that of v^2, over all batches of the levels; 1 where either is zero.
Scaled displacement_share(const Level* level, int levels, int dof);
// The DOF moves in this batch: over the least motion, 2^-34 of its mean motion energy in the level (a DOF held by friction
// does not move), and with an instrument, whose noise is its own, the noise-free part of the energy is more than the noise.
bool moves(const BatchDof& dof, bool instrument, const Scaled& least_motion);

}  // namespace firmware
