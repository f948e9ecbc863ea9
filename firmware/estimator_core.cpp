#include "firmware/estimator_core.hpp"

#include "firmware/warrant/verdict.hpp"

namespace firmware {
namespace {

constexpr uint32_t kLongestBlock = kBlockSamples;

// Something has moved: where nothing has, there is nothing to test.
bool any_estimate(const Estimates& estimates) {
  for (int k = 0; k < estimates.unknown_count; ++k) {
    const EstimateStatus status = estimates.parameters[k].status;
    if (status != EstimateStatus::kStale && status != EstimateStatus::kNoExcitation) return true;
  }
  return false;
}

ClearSigns clear_signs(const CoreConfiguration& configuration, const EnergySums& sums) {
  ClearSigns signs;
  for (int l = 0; l < configuration.link_count; ++l) signs.link[l] = sums.takes_clear_sign(l);
  for (int i = 0; i < configuration.dof_count; ++i) signs.dof[i] = sums.leaves_samples_out(i);
  signs.filtered = configuration.filters_sign();
  return signs;
}

}  // namespace

EstimatorCore::EstimatorCore(const CoreConfiguration& configuration, CoreDetail detail)
    : configuration_(configuration), memory_(), score_test_() {
  conditioning_.configure(configuration);
  sums_.configure(configuration, static_cast<int>(detail));
  probes_ = detail == CoreDetail::kFull && configuration.probe_products_per_sample > 0;
  if (probes_) score_sums_.configure(configuration, sums_.effect_units(), clear_signs(configuration, sums_));
  reset();
}

void EstimatorCore::reset() {
  collector_.clear(configuration_, sums_.layout());
  if (probes_) score_sums_.clear();
  estimates_ = Estimates{};
  estimates_.unknown_count = configuration_.unknown_count;
  health_ = CoreHealth{};
  sequence_known_ = false;
  conditioning_.restart();
  sums_.restart();
  filled_ = 0;
  level_samples_ = units_ = 0;
}

void EstimatorCore::begin_level() {
  end_level();
  collector_.begin_level();
  if (probes_) score_sums_.begin_level();
  sequence_known_ = false;  // what lies between levels is not missed
  if (collector_.level_open()) aim();
}

void EstimatorCore::push(const RawSample& sample) {
  ++health_.samples;
  if (sequence_known_ && sample.sequence != next_sequence_) {
    health_.missed_samples += sample.sequence - next_sequence_;
    break_window();
  }
  next_sequence_ = sample.sequence + 1;
  sequence_known_ = true;
  collector_.advance();
  const bool usable = conditioning_.append(sample, frame_, filled_);
  if (conditioning_.saturated()) {
    ++health_.saturated_samples;
    collector_.mark_saturated();
  }
  if (!usable || !collector_.level_open()) return;
  ++filled_;
  if (probes_) score_sums_.work();
  if (filled_ == full_) process(full_ - kLevelMarginSamples);
}

// A block ends where the batch ends, at the latest after kBlockSamples.
void EstimatorCore::choose_block() {
  const uint32_t rest = aim_ - level_samples_;
  full_ = kLevelMarginSamples + static_cast<int>(rest < kLongestBlock ? rest : kLongestBlock);
}

void EstimatorCore::aim() {
  units_aimed_ = units_ + collector_.units_wanted();
  aim_ = collector_.unit_end(units_aimed_);
  choose_block();
}

// Works on the block, then moves the frame on by its length.
void EstimatorCore::process(int count) {
  sums_.add_block(frame_, count);
  if (probes_) score_sums_.offer(frame_, count);
  level_samples_ += static_cast<uint32_t>(count);
  if (level_samples_ == aim_) {
    sums_.close_batch(frame_, kLeadIn + count, batch_);
    collector_.add(batch_, units_aimed_ - units_);
    units_ = units_aimed_;
    aim();
  }
  filled_ -= count;
  conditioning_.move_frame(frame_, count, filled_);
  choose_block();
}

// Closes the batch at the last sample that has its context, and starts again with the next sample.
void EstimatorCore::break_window() {
  if (!collector_.level_open()) return;
  const int rest = filled_ - kLevelMarginSamples;
  if (rest >= 0) {
    sums_.add_block(frame_, rest);
    if (sums_.samples() > 0) {
      sums_.close_batch(frame_, kLeadIn + rest, batch_);
      collector_.add(batch_, 0);
    }
  }
  conditioning_.restart();
  if (probes_) score_sums_.finish();
  if (probes_) score_sums_.restart();
  sums_.restart();
  filled_ = 0;
  level_samples_ = units_ = 0;
  aim();
}

void EstimatorCore::end_level() {
  break_window();
  collector_.end_level();
}

const Estimates& EstimatorCore::solve() {
  collector_.settle();
  identify(configuration_, table_, memory_, estimates_);
  if (!probes_) return estimates_;
  score_sums_.flush();
  const bool calibrated = !configuration_.noise_unknown;
  const bool judged =
      calibrated && any_estimate(estimates_) && score_test_.judge(configuration_, score_sums_, estimates_);
  give_verdict(configuration_, score_sums_, score_test_, {calibrated, judged, table_.level_count}, estimates_);
  return estimates_;
}

}  // namespace firmware
