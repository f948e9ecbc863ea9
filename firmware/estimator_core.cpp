#include "firmware/estimator_core.hpp"

#include "firmware/identification/identification.hpp"

namespace firmware {
namespace {

int smaller(uint32_t a, int b) { return a < static_cast<uint32_t>(b) ? static_cast<int>(a) : b; }

}  // namespace

EstimatorCore::EstimatorCore(const CoreConfiguration& configuration, CoreDetail detail) : configuration_(configuration) {
  conditioning_.configure(configuration);
  sums_.configure(configuration, static_cast<int>(detail));
  reset();
}

void EstimatorCore::reset() {
  collector_.clear(configuration_, sums_.layout());
  estimates_ = Estimates{};
  estimates_.unknown_count = configuration_.unknown_count;
  health_ = CoreHealth{};
  sequence_known_ = false;
  filled_ = 0;
}

void EstimatorCore::begin_level() {
  end_level();
  collector_.begin_level();
}

void EstimatorCore::push(const RawSample& sample) {
  ++health_.samples;
  if (sequence_known_ && sample.sequence != next_sequence_) {
    health_.missed_samples += sample.sequence - next_sequence_;
    break_window();
  }
  next_sequence_ = sample.sequence + 1;
  sequence_known_ = true;
  const bool usable = conditioning_.append(sample, frame_, filled_);
  if (conditioning_.saturated()) {
    ++health_.saturated_samples;
    collector_.mark_saturated();
  }
  if (!usable || !collector_.level_open()) return;
  ++filled_;
  const int block = smaller(collector_.batch_length(), kBlockSamples);
  if (filled_ == kLeadIn + block + kLeadOut) process(block);
}

// Works on the block, then moves the frame on by its length.
void EstimatorCore::process(int count) {
  sums_.add_block(frame_, count);
  if (sums_.samples() >= static_cast<uint32_t>(smaller(collector_.batch_length(), kMaxBatchSamples)))
    close_batch(kLeadIn + count);
  filled_ -= count;
  conditioning_.move_frame(frame_, count, filled_);
}

void EstimatorCore::close_batch(int boundary) {
  sums_.close_batch(frame_, boundary, batch_);
  collector_.add(batch_);
}

// Closes the batch at the last sample that has its context, and starts again with the next sample.
void EstimatorCore::break_window() {
  if (!collector_.level_open()) return;
  const int rest = filled_ - kLevelMarginSamples;
  if (rest >= 0) {
    sums_.add_block(frame_, rest);
    if (sums_.samples() > 0) close_batch(kLeadIn + rest);
  }
  conditioning_.restart();
  sums_.restart();
  filled_ = 0;
}

void EstimatorCore::end_level() {
  break_window();
  collector_.end_level();
}

const Estimates& EstimatorCore::solve() {
  identify(configuration_, table_, estimates_);
  return estimates_;
}

}  // namespace firmware
