// Decides from the response itself whether a rig has settled at an excitation level.
//
// The response energy of each DOF is taken over blocks (a whole number of excitation cycles):
//   E = sum (x - mean x)^2 / block length,  x in ADC codes.
// Settled when, for every DOF, the last `blocks` energies differ by no more than bound_per_mille of the largest, or all
// of them lie under the noise floor. A slow beat between the drive and a lightly damped resonance keeps the energies
// apart until it has died out, provided that the blocks together span half a beat.
//
// Arithmetic: codes limited to 24 bits with sign, squares 2^46, sums over at most 65,535 samples below 2^62 in int64;
// the mean is taken off as mean * (2 sum - n mean), which stays below 2^62 as well.
#pragma once
#include <cstdint>

#include "firmware/configuration/capacity.hpp"

namespace firmware {

struct SettleCriterion {
  uint32_t block_samples = 0;     // 0: nothing to wait for; at most 65,535
  uint16_t bound_per_mille = 20;  // largest spread of the energies
  uint8_t blocks = 4;             // energies compared, 2 to kMaxBlocks
  uint32_t floor_code = 2;        // rms response in codes under which a DOF counts as at rest
};

class SettleDetector {
 public:
  static constexpr int kMaxBlocks = 8;
  static constexpr uint32_t kMaxBlockSamples = 65535;

  void begin(const SettleCriterion& criterion, int dof_count);
  // response_code: one code per DOF, offset removed. True from the sample on that completes the last block needed.
  bool push(const int32_t* response_code);

 private:
  void close_block();
  bool dof_settled(int dof) const;

  SettleCriterion criterion_;
  int dof_count_ = 0;
  uint32_t samples_ = 0;
  uint32_t blocks_ = 0;
  bool settled_ = false;
  int64_t sum_[kMaxDofs] = {};
  int64_t square_sum_[kMaxDofs] = {};
  int64_t energy_[kMaxDofs][kMaxBlocks] = {};
};

}  // namespace firmware
