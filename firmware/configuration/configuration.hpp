// What the core needs to know of a rig, as plain integers: made once at start from the rig file, never changed while running.
#pragma once
#include <cstdint>

#include "firmware/configuration/capacity.hpp"
#include "firmware/fixed_point/scaled.hpp"

namespace firmware {

enum class Quantity : uint8_t { kForce = 0, kDisplacement = 1, kVelocity = 2, kAcceleration = 3 };
constexpr int kQuantities = 4;

// One measured channel. value in SI units = (code - offset_code) * unit_per_code.
struct ChannelConfiguration {
  bool present = false;
  int32_t offset_code = 0;
  int32_t full_scale_code = 8388607;  // |code| at or above this is a saturated sensor; 24 bits at the most
  Scaled unit_per_code;               // N, m, m/s, m/s^2 (rotating DOF: N m, rad, rad/s, rad/s^2) per code
  int32_t delay_ns = 0;               // how late the channel is against the others; removed in conditioning
};

// A link between two nodes: elongation u = x_a - x_b, rate w = v_a - v_b; its force acts on a with -1, on b with +1.
struct LinkConfiguration {
  uint8_t node_a = 0;            // 0 .. kMaxDofs-1, kBaseNode or kGroundNode
  uint8_t node_b = kGroundNode;
};

// The force (or torque) of a term per unit coefficient; for a mass it is the acceleration of its DOF.
enum class TermKind : uint8_t {
  kMass,                           // m a
  kStiffness,                      // k u
  kViscous,                        // c w
  kCoulomb,                        // F sgn(w)
  kGravity,                        // G sin(u)
  kCubicStiffness,                 // k3 u^3
  kQuadraticStiffness,             // k2 u^2
  kBacklash,                       // k u outside the gap: coefficient -k times clamp(u, -gap, gap); shape = gap
  kEndStop,                        // ke (|u| - gap) sgn(u) beyond the gap; shape = gap
  kQuadraticDamping,               // c2 w |w|
  kCubicDamping,                   // c3 w^3
  kStribeck,                       // Fs exp(-|w| / vs) sgn(w); shape = vs
  kPreslidingHysteresis,           // Dahl force of unit level; shape = presliding length
  kForceOffset,                    // F0
  kAsymmetricViscous,              // c_a |w|: c + c_a for w > 0, c - c_a for w < 0
  kDisplacementDependentDamping,   // c_u u^2 w
  kDriftingViscous,                // c_t w t, t in s since the start of the level
};

struct Term {
  TermKind kind = TermKind::kMass;
  uint8_t place = 0;      // DOF index for kMass, link index otherwise
  int8_t unknown = -1;    // index among the unknowns, -1 where the coefficient is known
  Scaled value;           // the coefficient, SI units, where known
  Scaled shape;           // shape parameter of an effect, SI units
};

enum class WindowMode : uint8_t {
  kWholeCycles,  // periodic excitation: one row per DOF and level over a whole number of cycles
  kInterval,     // arbitrary finite intervals (Eq. 12a): every batch is a row
  kFreeDecay,    // as kInterval, without force
};

struct WindowConfiguration {
  WindowMode mode = WindowMode::kInterval;
  // kWholeCycles: samples per excitation cycle as a fraction; the window ends on the sample nearest to a whole cycle.
  uint32_t cycle_samples_numerator = 0;
  uint32_t cycle_samples_denominator = 1;
  uint32_t batch_samples = 512;  // length of the first batches (rounded to whole blocks or whole cycles)
};

struct CoreConfiguration {
  uint8_t dof_count = 0;
  uint8_t link_count = 0;
  uint8_t term_count = 0;
  uint8_t unknown_count = 0;
  bool base_present = false;          // a moving base has channels at nodes[kBaseNode]
  Scaled sample_period_s;
  LinkConfiguration links[kMaxLinks];
  Term terms[kMaxTerms];
  ChannelConfiguration channels[kMaxNodes][kQuantities];
  WindowConfiguration window;
};

}  // namespace firmware
