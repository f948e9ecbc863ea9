// The running energy sums of every DOF, kept as consecutive batches of whole blocks: the only thing that the identification
// stage sees. A batch row holds, for one DOF i and one weight q, the energies of Eq. 9 to 12a per unit coefficient,
//   column[k] = integral of q_i * (force of unknown k on DOF i per unit coefficient) dt,  k over the unknowns that touch DOF i
//   rhs       = integral of q_i * f_i dt  -  sum over known terms of coefficient * integral of q_i * force dt
// so that  sum_k column[k] * p_k = rhs  holds for noise-free data. All in SI units (energies in J per unit of the coefficient).
//
// Weights q: the velocity itself (plain: the paper's), an instrument for the velocity whose noise is independent of the
// sample's own (interpolated from its neighbours), and the displacement, interpolated likewise (shows masses and stiffnesses).
//
// Kinematic discrepancies: identities that hold for any rig, so what they show is sensor noise and skew alone.
//   velocity weights:  kinetic = integral(q a) - (v_end^2 - v_start^2) / 2       per unit mass
//                      elastic = integral(q x) - (x_end^2 - x_start^2) / 2       per unit stiffness to ground
//   displacement:      kinetic = integral(x a) + integral(v v) - [x v]
// They let the identification choose, per DOF, between the integral form and the end-point form of the kinetic and elastic
// energy (or mix them: they are control variates), and measure skew: elastic = -tau_xv * integral(v^2), likewise v against a.
//
// When the table of a level is full, neighbouring batches merge pairwise: the batch length doubles, nothing is lost.
#pragma once
#include <cstdint>

#include "firmware/configuration/configuration.hpp"

namespace firmware {

constexpr int kMaxIncidences = 2 * kMaxUnknowns;  // (DOF, unknown) pairs of the rig: a link's unknown touches two DOFs

// Which unknowns stand in each DOF's equation; the same for all weights.
struct RowLayout {
  uint8_t dof_count = 0;
  uint8_t unknown_count = 0;
  uint8_t weight_count = kWeights;   // the numbers of the others are 0
  uint8_t first[kMaxDofs + 1] = {};  // unknowns of DOF i: unknown[first[i]] .. unknown[first[i + 1] - 1]
  uint8_t unknown[kMaxIncidences] = {};
};

// 64-bit storage of a Scaled: 48-bit mantissa, 16-bit exponent; relative rounding 2^-47.
struct PackedScaled {
  int64_t bits = 0;
};
PackedScaled pack(const Scaled& value);
Scaled unpack(PackedScaled packed);
PackedScaled operator+(PackedScaled a,
                       PackedScaled b);  // the same bits as pack(unpack(a) + unpack(b)), in a third of the work

struct BatchDof {
  PackedScaled rhs[kWeights];
  PackedScaled kinetic_discrepancy[kWeights];
  PackedScaled elastic_discrepancy[kWeights];  // of the velocity weights; the third place is displacement_square()
  PackedScaled kinetic_end;                    // (v_end^2 - v_start^2) / 2, per unit mass
  PackedScaled elastic_end;                    // (x_end^2 - x_start^2) / 2, per unit stiffness
  PackedScaled velocity_square;                // integral of v^2 dt
  PackedScaled velocity_instrument;  // integral of v z dt: velocity_square minus this is the noise energy of v
  // integral of v times the weight of the velocity row: velocity_instrument without the samples in which a friction has no
  // clear sign
  PackedScaled weight_square;
  PackedScaled acceleration_square;  // integral of a^2 dt, 0 where a is not measured

  // Integral of x times the weight of the displacement row dt; only where that weight is summed.
  PackedScaled& displacement_square() { return elastic_discrepancy[kWeights - 1]; }
  const PackedScaled& displacement_square() const { return elastic_discrepancy[kWeights - 1]; }
};

struct Batch {
  uint32_t samples = 0;
  PackedScaled column[kWeights][kMaxIncidences];  // index as RowLayout::unknown
  BatchDof dof[kMaxDofs];
};

struct Level {
  uint16_t batch_count = 0;
  uint16_t merges = 0;     // how often the table was full: first batches are 2^merges initial lengths long
  bool periodic = false;   // WindowMode::kWholeCycles
  bool saturated = false;  // a sensor or an accumulator reached its limit in this level
  bool closed = false;     // the level has ended: its last batch may be shorter than the others
  Batch batch[kMaxBatches];
};

struct BatchTable {
  RowLayout layout;
  Scaled sample_period_s;
  uint8_t level_count = 0;  // the last one is being filled
  Level level[kMaxLevels];
};

}  // namespace firmware
