// Compile-time capacity of the core. Everything is statically allocated to these sizes, and everything else follows from
// them. Define a macro for the core and your program alike to make a smaller core (docs/memory_budget.md has what some
// choices cost); what a rig file needs beyond them is refused when its configuration is decoded.
#pragma once
#include <cstdint>

#ifndef FIRMWARE_MAX_DOFS
#define FIRMWARE_MAX_DOFS 16
#endif
#ifndef FIRMWARE_MOVING_BASE  // 0: no rig stands on a base that moves
#define FIRMWARE_MOVING_BASE 1
#endif
#ifndef FIRMWARE_MAX_LINKS
#define FIRMWARE_MAX_LINKS 32
#endif
#ifndef FIRMWARE_MAX_UNKNOWNS
#define FIRMWARE_MAX_UNKNOWNS 48
#endif
#ifndef FIRMWARE_MAX_TERMS  // known and unknown coefficients of the rig together
#define FIRMWARE_MAX_TERMS 96
#endif
#ifndef FIRMWARE_MAX_EFFECTS  // terms beyond mass, stiffness, viscous and Coulomb damping
#define FIRMWARE_MAX_EFFECTS 32
#endif
#ifndef FIRMWARE_MAX_LEVELS  // excitation levels (or records) kept for one estimate
#define FIRMWARE_MAX_LEVELS 8
#endif
#ifndef FIRMWARE_MAX_BATCHES  // consecutive batches kept per level; pairs merge when the table is full
#define FIRMWARE_MAX_BATCHES 128
#endif
#ifndef FIRMWARE_MAX_WEIGHTS  // 3; 2 where masses, springs and other conservative terms are all known
#define FIRMWARE_MAX_WEIGHTS 3
#endif
#ifndef FIRMWARE_MAX_PRODUCTS  // different pairs of columns that the equations need
#define FIRMWARE_MAX_PRODUCTS 1024
#endif
#ifndef FIRMWARE_BLOCK_SAMPLES  // 32, or 16 for less memory and more instructions
#define FIRMWARE_BLOCK_SAMPLES 32
#endif
#ifndef FIRMWARE_FILTER_HALF  // reach of the filters of derived channels; 0 where every channel is measured
#define FIRMWARE_FILTER_HALF 28
#endif
#ifndef FIRMWARE_MAX_WAITING  // samples that come during one solve; a board without a worker needs no more than 64
#define FIRMWARE_MAX_WAITING 1024
#endif
#ifndef FIRMWARE_CAN_FD  // 0: frames of up to 8 bytes alone wait to be sent
#define FIRMWARE_CAN_FD 1
#endif
#ifndef FIRMWARE_WARRANT_NUMBERS  // sums of the score tests, 5 bytes each; 0: no score tests, and no memory for them
#define FIRMWARE_WARRANT_NUMBERS 65536
#endif
#ifndef FIRMWARE_WARRANT_PROBES
#define FIRMWARE_WARRANT_PROBES 448
#endif
#ifndef FIRMWARE_WARRANT_STRETCHES
#define FIRMWARE_WARRANT_STRETCHES 256
#endif

namespace firmware {

constexpr int kMaxDofs = FIRMWARE_MAX_DOFS;
constexpr int kMaxLinks = FIRMWARE_MAX_LINKS;
constexpr int kMaxUnknowns = FIRMWARE_MAX_UNKNOWNS;
constexpr int kMaxTerms = FIRMWARE_MAX_TERMS;
constexpr int kMaxEffectColumns = FIRMWARE_MAX_EFFECTS;
constexpr bool kHasBase = FIRMWARE_MOVING_BASE != 0;
constexpr int kMaxNodes = kMaxDofs + (kHasBase ? 1 : 0);  // the DOFs and the moving base
constexpr int kBaseNode = kHasBase ? kMaxDofs : 255;      // index of the moving base among the nodes
constexpr int kGroundNode = kMaxNodes;                    // fixed ground: no channels
constexpr int kBlockSamples = FIRMWARE_BLOCK_SAMPLES;     // samples per block of the energy sums
constexpr int kMaxBatchSamples =
    1024;  // exact int64 sums hold this many full-scale products (firmware/acquisition/columns.hpp)
constexpr int kMaxLevels = FIRMWARE_MAX_LEVELS;
constexpr int kMaxBatches = FIRMWARE_MAX_BATCHES;
constexpr int kMaxProducts = FIRMWARE_MAX_PRODUCTS;
constexpr int kMaxWaiting = FIRMWARE_MAX_WAITING;
constexpr bool kSendsFd = FIRMWARE_CAN_FD != 0;
constexpr bool kDerivesSignals = FIRMWARE_FILTER_HALF > 0;
constexpr int kWarrantNumbers = FIRMWARE_WARRANT_NUMBERS;
constexpr int kMaxProbes = FIRMWARE_WARRANT_PROBES;
constexpr int kMostStretches = FIRMWARE_WARRANT_STRETCHES;

// What travels between machines (frames, stored configurations) is numbered as in the largest core, whatever this one holds.
constexpr int kWireDofs = 16, kWireUnknowns = 48;
constexpr int kWireNodes = kWireDofs + 1;
constexpr int kWireBase = kWireDofs, kWireGround = kWireNodes;
constexpr int wire_node(int node) { return node == kGroundNode ? kWireGround : node == kBaseNode ? kWireBase : node; }
// The node of a number from outside; -1 where this core has none such.
constexpr int node_of_wire(int number) {
  if (number == kWireGround) return kGroundNode;
  if (number == kWireBase) return kHasBase ? kBaseNode : -1;
  return number >= 0 && number < kMaxDofs ? number : -1;
}

static_assert(kMaxDofs >= 1 && kMaxDofs <= kWireDofs, "DOFs have 1 to 16 numbers on the wire");
static_assert(kBlockSamples == 16 || kBlockSamples == 32, "the sums work on these in steps of 4");
static_assert(kMaxUnknowns >= 1 && kMaxUnknowns <= kWireUnknowns, "unknowns have 48 identifiers on the wire");
static_assert(kMaxLinks >= 1 && kMaxLinks <= 127 && kMaxTerms >= 1 && kMaxTerms <= 255, "numbered in 8 bits");
static_assert(kMaxEffectColumns >= 1 && kMaxProducts >= 3, "arrays have at least one entry");
static_assert(kMaxLevels >= 1 && kMaxLevels <= 255, "numbered in 8 bits");
static_assert(kMaxBatches >= 4 && kMaxBatches % 2 == 0 && kMaxBatches <= 32766, "pairs of them merge");
static_assert(FIRMWARE_MAX_WEIGHTS == 2 || FIRMWARE_MAX_WEIGHTS == 3, "plain and instrument; displacement");
static_assert(FIRMWARE_FILTER_HALF >= 0 && FIRMWARE_FILTER_HALF <= 28, "sums of 57 taps fit 62 bits");

}  // namespace firmware
