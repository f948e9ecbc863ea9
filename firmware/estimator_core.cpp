#include "firmware/estimator_core.hpp"

#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/identification/rows/backward_time.hpp"

namespace firmware {
namespace {

constexpr uint32_t kLongestBlock = kBlockSamples;

}  // namespace

void EstimatorCore::begin_level() {
  end_level();
  if (forgets_) forget_levels();
  collector_.begin_level();
  tests_.begin_level();
  level_began_ = health_.samples;
  sequence_known_ = false;  // what lies between levels is not missed
  if (collector_.level_open()) aim();
}

void EstimatorCore::push(const RawSample& sample) {
  ++health_.samples;
  const uint32_t sequence = sample.sequence;
  if (sequence != next_sequence_) note_gap(sequence);
  next_sequence_ = sequence + 1;
  sequence_known_ = true;
  // What can wait goes on in the steps that do not work on a block.
  if (filled_columns_ == 0 && filled_ + 1 != full_) {
    collector_.advance();
    if (closing_) close_some();
  }
  const bool usable = conditioning_->append(sample, frame_, filled_);
  if (conditioning_->saturated()) note_saturation();
  if (!usable || !collector_.level_open()) {
    ++unfed_;
    starved_ = starved_ || (!usable && collector_.level_open());
    return;
  }
  ++filled_;
  if (tests_work_) tests_.work();
  if (filled_columns_ != 0) move_on();
  if (filled_ == full_) process(full_ - kLevelMarginSamples);
}

void EstimatorCore::note_saturation() {
  ++health_.saturated_samples;
  collector_.mark_saturated();
}

void EstimatorCore::note_gap(uint32_t sequence) {
  if (!sequence_known_) return;
  const uint32_t missed = sequence - next_sequence_;
  health_.missed_samples += missed;
  level_began_ -=
      missed < 0x80000000u ? missed : 1;  // a counter that went back tells that something is missing, not how much
  break_window(health_.samples - 1 - level_began_);
}

void EstimatorCore::close_some() {
  for (int piece = 0; piece < pieces_per_sample_ && closing_; ++piece) go_on_closing();
}

// A block ends where the batch ends, at the latest after kBlockSamples.
void EstimatorCore::choose_block() {
  const uint32_t rest = aim_ - level_samples_;
  full_ = kLevelMarginSamples + static_cast<int>(rest < kLongestBlock ? rest : kLongestBlock);
}

void EstimatorCore::aim(uint32_t units) {
  units_aimed_ = units_ + collector_.units_wanted(units);
  aim_ = collector_.unit_end(units_aimed_);
  choose_block();
}

// Works on the block: its columns now, its sums with the next sample, for which there is just room in the frame, and then the
// frame moves on. Two steps bear what one would.
void EstimatorCore::process(int count) {
  fill_columns(count);
  tests_.offer(frame_, count);
  level_samples_ += static_cast<uint32_t>(count);
  filled_columns_ = count;
}

// Where time is out the columns of a drift are not what they stand for.
void EstimatorCore::fill_columns(int count) {
  stages_->sums.fill_columns(frame_, count);
  if (stages_->sums.time_is_out()) collector_.mark_saturated();
}

void EstimatorCore::move_on() {
  const int count = filled_columns_;
  if (count == 0) return;
  filled_columns_ = 0;
  stages_->sums.add_block(frame_, count);
  report_work(150 * count);
  if (level_samples_ == aim_) {
    finish_closing();
    stages_->sums.begin_close(frame_, kLeadIn + count);
    report_work(4000);
    closing_ = true;
    closing_units_ = units_aimed_ - units_;
    units_ = units_aimed_;
    collector_.count_anew(units_, level_samples_);
    aim(closing_units_);
    // Done in half the time until the next one closes.
    const uint32_t samples = 1 + (aim_ - level_samples_) / 2;
    pieces_per_sample_ = 1 + stages_->sums.closing_pieces() / static_cast<int>(samples);
    if (stages_->sums.closes_at_once()) finish_closing();
  }
  filled_ -= count;
  conditioning_->move_frame(frame_, count, filled_);
  choose_block();
}

void EstimatorCore::go_on_closing() {
  if (!stages_->sums.go_on_closing(stages_->batch)) return;
  closing_ = false;
  collector_.add(stages_->batch, closing_units_);
}

void EstimatorCore::finish_closing() {
  while (closing_) go_on_closing();
}

// Closes the batch at the last sample that has its context, and starts again with the next sample.
void EstimatorCore::break_window(uint32_t time) {
  if (!collector_.level_open()) return;
  move_on();
  finish_closing();
  const int rest = filled_ - kLevelMarginSamples;
  if (rest >= 0) {
    fill_columns(rest);
    stages_->sums.add_block(frame_, rest);
    if (stages_->sums.samples() > 0) {
      stages_->sums.close_batch(frame_, kLeadIn + rest, stages_->batch);
      collector_.add(stages_->batch, 0);
    }
  }
  conditioning_->restart();
  tests_.break_window();
  stages_->sums.restart(time);
  filled_ = 0;
  level_samples_ = units_ = 0;
  aim();
}

void EstimatorCore::end_level() {
  break_window();
  collector_.end_level();
}

const Estimates& EstimatorCore::solve() {
  move_on();
  finish_closing();
  collector_.settle();
  if (corrections_->any() && !any_batch(table_)) return estimates_;  // nothing yet of the corrected channel
  identify(configuration_, table_, stages_->memory, estimates_);
  if (corrections_->any()) corrections_->widen(configuration_, table_, estimates_);
  tests_.judge(table_.level_count, estimates_);
  if (configuration_.runs_back()) run_forward(configuration_, estimates_);
  if (kCorrectsChannels) correct_channels();
  tell_stale();
  return estimates_;
}

// Behind a gap, or at the start of a further level: who waits for news must see that these numbers are none. At a level's end they are
// its result.
void EstimatorCore::tell_stale() {
  if (kDerivesSignals && starved_ && unfed_ == health_.samples - told_samples_ && collector_.level_open())
    for (int k = 0; k < estimates_.unknown_count; ++k)
      if (estimates_.parameters[k].status == EstimateStatus::kValid)
        estimates_.parameters[k].status = EstimateStatus::kStale;
  starved_ = false, unfed_ = 0, told_samples_ = health_.samples;
}

// Where no level is open the next one is the first that counts.
void EstimatorCore::correct_channels() {
  const bool takes = configuration_.corrects_channels && corrections_->take(configuration_, estimates_);
  if (!takes) return corrections_->tell(estimates_);
  forgets_ = true;
  if (!collector_.level_open()) return;
  forget_levels();
  collector_.begin_level();
  tests_.begin_level();
  level_began_ = health_.samples;
  aim();
}

}  // namespace firmware
