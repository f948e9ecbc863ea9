// What the core needs to know of a rig, as plain integers: made once at start from the rig file, never changed while running.
#pragma once
#include <cstdint>

#include "firmware/configuration/capacity.hpp"
#include "firmware/fixed_point/fixed.hpp"
#include "firmware/fixed_point/scaled.hpp"
#include "firmware/vocabulary/kinds.hpp"

namespace firmware {

enum class Quantity : uint8_t { kForce = 0, kDisplacement = 1, kVelocity = 2, kAcceleration = 3 };
constexpr int kQuantities = 4;

// What an energy equation is multiplied with (firmware/energy/batch_table.hpp).
enum class Weight : uint8_t { kPlain = 0, kInstrument = 1, kDisplacement = 2 };
constexpr int kWeights = FIRMWARE_MAX_WEIGHTS;
// Never where there is no room for the displacement's sums: what they ask for is then left out of the image.
constexpr bool kHasDisplacementRows = kWeights > static_cast<int>(Weight::kDisplacement);
constexpr bool is_displacement(int weight) {
  return kHasDisplacementRows && weight == static_cast<int>(Weight::kDisplacement);
}

constexpr int32_t kLargestCode = 8388607;  // 24 bits with sign

// One measured channel. value in SI units = (code - offset_code) * unit_per_code.
struct ChannelConfiguration {
  bool present = false;
  int32_t offset_code = 0;
  // The converter's rails: a code at or beyond one of them is a saturated sensor. code - offset_code holds 24 bits with
  // sign; what enters beyond that is clamped and counts as saturated.
  int32_t lowest_code = -kLargestCode;
  int32_t highest_code = kLargestCode;
  Scaled unit_per_code;  // N, m, m/s, m/s^2 (rotating DOF: N m, rad, rad/s, rad/s^2) per code
  int32_t delay_ns = 0;  // how late the channel is against the others; removed in conditioning
};

// How a signal that the equations use is made from a measured channel of the same node. Arithmetic:
//   measured code (24 bits)  ->  integrations and high-pass (int64 state, 16 fraction bits)  ->  FIR (integer taps, int64 sum below 2^62)
//   ->  rounded shift  ->  signal, saturated to +-2^23 (which counts as SATURATED).
// half_length 0 with a first tap of 0 is a plain copy. The same delay (the plan's longest half_length) holds for all signals.
// An integration's output is the running sum of its input, divided by 2^(high_pass_shift - kIntegrationExtraBits); what the last one
// gives is divided by 2^dropped_bits.
constexpr int kFilterHalf = FIRMWARE_FILTER_HALF;
constexpr int kIntegrationExtraBits = 6;
struct SignalConfiguration {
  bool available = false;
  bool derived = false;  // made from another quantity than its own
  bool is_derived() const { return kDerivesSignals && derived; }
  uint8_t source = 0;                          // the measured Quantity it is made from
  uint8_t integrations = 0;                    // how often the source is integrated (leaky, see high_pass_shift)
  uint8_t half_length = 0;                     // FIR reaches from -half_length to +half_length samples
  uint8_t shift = 0;                           // result = FIR sum / 2^shift, rounded
  uint8_t dropped_bits = 0;                    // of an integral, rounded, so that 32 bits hold it
  Fixed<int32_t, 0> tap[2 * kFilterHalf + 1];  // integer weights; tap[0] weighs the oldest sample
  Scaled unit_per_code;                        // SI units per signal code
};

// A velocity made from displacement and acceleration: the slope of x, of which what changes faster than the corner is replaced
// by the integral of a. Both halves are filtered by complements, so noise-free channels give the velocity itself, without a
// filter on any other signal; the noise is that of x below the corner and that of a above it.
//   v = x' + H H (integral of a - x'),   H = (1 - z^-1) / (1 - (1 - 2^-leak_shift) z^-1)
// x' is the FIR of SignalConfiguration on x, the step of the integral the FIR below on a, with the same half_length and shift.
constexpr int kFusionHalf = kFilterHalf < 12 ? kFilterHalf : 12;
struct FusionConfiguration {
  bool used = false;
  uint8_t leak_shift = 5;
  Fixed<int32_t, 0> step_tap[2 * kFusionHalf + 1];
};

constexpr int kSignFilterHalf = kDerivesSignals ? 12 : 0;
using PassedSign = Fixed<int32_t, 20>;  // the sign of friction behind a filter

// A link between two nodes: elongation u = x_a - x_b, rate w = v_a - v_b; its force acts on a with -1, on b with +1.
struct LinkConfiguration {
  uint8_t node_a = 0;  // 0 .. kMaxDofs-1, kBaseNode or kGroundNode
  uint8_t node_b = kGroundNode;
};

struct Term {
  TermKind kind = TermKind::kMass;
  uint8_t place = 0;             // DOF index for kMass, link index otherwise
  int8_t unknown = -1;           // index among the unknowns, -1 where the coefficient is known
  int32_t second_shape_q26 = 0;  // further shape parameter of an effect, SI units (a phase in radians); within +-32
  Scaled value;                  // the coefficient, SI units, where known
  Scaled shape;                  // shape parameter of an effect, SI units
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
  // Length of the first batches, 8 to 1024 samples; it doubles whenever a level's table is full. 0: a sixteenth of a cycle
  // for whole cycles, else 32.
  uint32_t batch_samples = 0;
};

// What the score tests may cost a sample, apart from a number of products (firmware/warrant/probes/probe_budget.hpp):
constexpr uint16_t kAllProbes = 65535;      // every candidate on every sample
constexpr uint16_t kDefaultProbes = 65534;  // the same at the start of each level, then 1.6 times the core

// What the score tests' instruments share with a node's own signals through filters (firmware/warrant/probes/shared_noise.hpp): mean
// products of noise, SI units. An instrument is interpolated from the four neighbours on either side.
enum class ProbeWeight : uint8_t { kDisplacement, kVelocity, kAcceleration, kAccelerationSlope, kForce, kNone };
constexpr int kMotionProbeWeights = 4;
constexpr bool kKeepsProbeNoise = kDerivesSignals && kWarrantNumbers > 0;  // else there is nobody to share it
struct ProbeNoise {
  Scaled motion[kMotionProbeWeights][kQuantities - 1];  // with displacement, velocity and acceleration
  Scaled force;                                         // of the interpolated force with the force
};

struct CoreConfiguration {
  // Out of line, so that one of static storage is filled at start: its initial values take no room in flash.
  CoreConfiguration();
  struct AtCompileTime {};
  constexpr explicit CoreConfiguration(AtCompileTime) {}
  uint8_t dof_count = 0;
  uint8_t link_count = 0;
  uint8_t term_count = 0;
  uint8_t unknown_count = 0;
  bool base_present = false;  // a moving base has channels at nodes[kBaseNode]
  Scaled sample_period_s;
  LinkConfiguration links[kMaxLinks];
  Term terms[kMaxTerms];
  ChannelConfiguration channels[kMaxNodes][kQuantities];  // as measured
  SignalConfiguration signals[kMaxNodes][kQuantities];    // as the equations use them
  FusionConfiguration fusion[kMaxNodes];                  // of a node's velocity
  // Mean product of the noise in a weight of a node's equation (plain, instrument, displacement) with the noise in the node's own
  // signal, SI units: what filters make them share. Taken out of the energies; 0 where nothing is shared or known.
  Scaled shared_noise[kMaxNodes][kWeights][kQuantities];
  ProbeNoise probe_noise[kKeepsProbeNoise ? kMaxNodes : 1];
  bool shares_probe_noise = false;  // probe_noise holds something
  bool noise_unknown = false;       // signals pass filters, and nobody has said how much noise their channels have
  bool calibrates_tests() const { return !kDerivesSignals || !noise_unknown; }
  // The products above of a node's motion and of its force may be off by this many thousandths of themselves.
  uint16_t motion_noise_doubt[kMaxNodes] = {};
  uint16_t force_noise_doubt[kMaxNodes] = {};
  // Every signal passes as many first-order high-pass sections (corner = rate / (2 pi 2^shift)) as the most integrated one has
  // integrations, plus one where any is integrated; an integration takes the place of one section's difference.
  uint8_t high_pass_order = 0;
  uint8_t high_pass_shift = 0;
  // Where every signal passes a low-pass, the sign of friction passes it too: taps, oldest first. 0: it passes none.
  uint8_t sign_half_length = 0;
  PassedSign sign_tap[2 * kSignFilterHalf + 1];
  bool asks_for_filtered_sign() const { return high_pass_order > 0 || sign_half_length > 0; }
  // These never where no channel is derived: such a core refuses what asks for it.
  bool filters_sign() const { return kDerivesSignals && asks_for_filtered_sign(); }
  bool runs_back() const { return kDerivesSignals && time_runs_back; }
  bool fuses(int node) const { return kDerivesSignals && fusion[node].used; }
  WindowConfiguration window;
  // What the score tests (firmware/warrant) may cost: products of two numbers a sample; 0: no tests.
  uint16_t probe_products_per_sample = kDefaultProbes;
  // A well-measured delay or gain of a channel is taken out on the board (firmware/warrant/verdict/channel_correction.hpp). Not stored: false
  // where the program beside the core has all the samples, and does it itself.
  bool corrects_channels = true;
  // The samples of each level come last first, velocities turned over: firmware/identification/rows/backward_time.hpp. Not stored: a board cannot.
  bool time_runs_back = false;
};

// Fills signals with plain copies of the measured channels.
void copy_measured_signals(CoreConfiguration& configuration);

// The term whose coefficient is that unknown; nullptr: none.
const Term* term_of(const CoreConfiguration& configuration, int unknown);

// Bits without sign that hold the full scale of a signal's codes: of what its channel's rails leave where it is taken as measured, at least
// `least`; all 23 of one that a filter makes, whose unit is chosen for that.
int full_scale_bits(const CoreConfiguration& configuration, int node, Quantity quantity, int least);

}  // namespace firmware
