// Compile-time capacity of the core. Everything is statically allocated to these sizes.
#pragma once

namespace firmware {

constexpr int kMaxDofs = 16;
constexpr int kMaxLinks = 32;
constexpr int kMaxUnknowns = 48;
constexpr int kMaxTerms = 96;            // known and unknown coefficients of the rig together
constexpr int kMaxNodes = kMaxDofs + 1;  // the DOFs and the moving base
constexpr int kBaseNode = kMaxDofs;      // index of the moving base among the nodes
constexpr int kGroundNode = kMaxNodes;   // fixed ground: no channels
constexpr int kBlockSamples = 32;        // samples per block of the energy sums
constexpr int kMaxBatchSamples =
    1024;  // exact int64 sums hold this many full-scale products (firmware/acquisition/columns.hpp)
#ifdef FIRMWARE_MAX_LEVELS
constexpr int kMaxLevels = FIRMWARE_MAX_LEVELS;
#else
constexpr int kMaxLevels = 8;     // excitation levels (or records) kept for one estimate
#endif
#ifdef FIRMWARE_MAX_BATCHES
constexpr int kMaxBatches = FIRMWARE_MAX_BATCHES;
#else
constexpr int kMaxBatches = 128;  // consecutive batches kept per level; pairs merge when the table is full
#endif

constexpr int kMaxProducts = 1024;  // different pairs of columns that the equations need

}  // namespace firmware
