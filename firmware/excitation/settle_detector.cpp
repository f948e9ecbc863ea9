// See settle_detector.hpp.
#include "firmware/excitation/settle_detector.hpp"

#include "firmware/excitation/drive.hpp"

namespace firmware {

void SettleDetector::begin(const SettleCriterion& criterion, int dof_count) {
  *this = SettleDetector{};
  criterion_ = criterion;
  if (criterion_.blocks < 2) criterion_.blocks = 2;
  if (criterion_.blocks > kMaxBlocks) criterion_.blocks = kMaxBlocks;
  dof_count_ = dof_count;
  settled_ = criterion_.block_samples == 0;
}

bool SettleDetector::push(const int32_t* response_code) {
  if (settled_) return true;
  for (int dof = 0; dof < dof_count_; ++dof) {
    const int64_t code = clamp_magnitude(response_code[dof], 1 << 23);
    sum_[dof] += code;
    square_sum_[dof] += code * code;
  }
  if (++samples_ == criterion_.block_samples) close_block();
  return settled_;
}

void SettleDetector::close_block() {
  const auto count = static_cast<int64_t>(samples_);
  for (int dof = 0; dof < dof_count_; ++dof) {
    const int64_t mean = sum_[dof] / count;
    const int64_t about_mean = square_sum_[dof] - mean * (2 * sum_[dof] - count * mean);
    energy_[dof][blocks_ % criterion_.blocks] = about_mean / count;
    sum_[dof] = 0;
    square_sum_[dof] = 0;
  }
  samples_ = 0;
  ++blocks_;
  if (blocks_ < criterion_.blocks) return;
  settled_ = true;
  for (int dof = 0; dof < dof_count_; ++dof) settled_ = settled_ && dof_settled(dof);
}

bool SettleDetector::dof_settled(int dof) const {
  int64_t smallest = energy_[dof][0];
  int64_t largest = energy_[dof][0];
  for (int block = 1; block < criterion_.blocks; ++block) {
    if (energy_[dof][block] < smallest) smallest = energy_[dof][block];
    if (energy_[dof][block] > largest) largest = energy_[dof][block];
  }
  const auto floor_energy = static_cast<int64_t>(static_cast<uint64_t>(criterion_.floor_code) * criterion_.floor_code);
  if (largest <= floor_energy) return true;
  return (largest - smallest) * 1000 <= largest * criterion_.bound_per_mille;  // energies below 2^47
}

}  // namespace firmware
