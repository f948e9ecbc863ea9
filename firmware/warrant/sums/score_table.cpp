#include "firmware/warrant/sums/score_table.hpp"

#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {
namespace {

int64_t shifted(int64_t sum, int bits) { return bits > 62 ? 0 : (sum + (int64_t{1} << (bits - 1))) >> bits; }

}  // namespace

void ScoreTable::configure(int values, const ProbePlan* plan, const PlaceScale* scale) {
  plan_ = plan;
  scale_ = scale;
  values_ = values;
  room_ = values > 0 ? kWarrantNumbers / values : 0;
  if (room_ > kMostStretches) room_ = kMostStretches;
  clear();
}

void ScoreTable::clear() {
  count_ = level_ = 0;
  open_ = merging_ = false;
  length_ = 1;
  pending_ = 0;
  pending_time_ = 0;
  for (int v = 0; v < values_; ++v) current_[v] = 0;
}

void ScoreTable::begin_level() {
  flush();
  open_ = false;
  ++level_;
}

void ScoreTable::add_block(uint32_t time_samples) {
  ++pending_;
  pending_time_ += time_samples;
  const uint32_t missing = open_ ? length_ - stretch_[count_ - 1].blocks : length_;
  if (pending_ >= missing || pending_ == kExactBlocks) flush();
}

void ScoreTable::rescale(int value, int bits) {
  if (bits <= 0) return;
  current_[value] = shifted(current_[value], bits);
  if (merging_) held_[value] = shifted(held_[value], bits);
}

void ScoreTable::flush() {
  settle();
  if (pending_ == 0) return;
  if (!open_ && count_ == room_) begin_merge();
  if (!open_ && count_ == room_) return drop();  // more levels than stretches: what comes is not tested
  held_in_new_row_ = !open_;
  if (!open_) {
    stretch_[count_++] = Stretch{static_cast<uint8_t>(level_), 0, 0};
    open_ = true;
  }
  report_work(35 * values_);
  if (!merging_ && held_in_new_row_) append_row();
  if (merging_) {
    for (int v = 0; v < values_; ++v) held_[v] = current_[v];
  } else {
    add_exact(current_);
  }
  for (int v = 0; v < values_; ++v) current_[v] = 0;
  close_stretch();
}

void ScoreTable::close_stretch() {
  Stretch& last = stretch_[count_ - 1];
  last.blocks += pending_;
  last.time += pending_time_;
  pending_ = 0;
  pending_time_ = 0;
  if (last.blocks >= length_) open_ = false;
}

void ScoreTable::drop() {
  for (int v = 0; v < values_; ++v) current_[v] = 0;
  pending_ = 0;
  pending_time_ = 0;
}

void ScoreTable::append_row() {
  for (int v = 0; v < values_; ++v) put(place(count_ - 1, v), {});
}

// To the last stretch.
void ScoreTable::add_exact(const int64_t* sums) {
  const int last = count_ - 1;
  if (plan_ == nullptr)
    for (int v = 0; v < values_; ++v) add_to(place(last, v), sums[v], 0);
  for (int j = 0; plan_ != nullptr && j < plan_->summed_count; ++j) {
    const Probe& probe = plan_->probe[j];
    const ProbeExponents exponents(*plan_, probe, scale_[probe.place]);
    const int values = plan_->values(probe);
    for (int v = 0; v < values; ++v)
      if (sums[probe.first_value + v] != 0)
        add_to(place(last, probe.first_value + v), sums[probe.first_value + v], exponents.of(v));
  }
}

// Neighbours of the same level; one that is left over at a level's end stays as it is, the last one goes on.
void ScoreTable::begin_merge() {
  rows_ = 0;
  for (int from = 0; from < count_; ++rows_, report_work(60)) {
    Row& row = merged_[rows_];
    row.from = static_cast<uint16_t>(from);
    row.pair = from + 1 < count_ && stretch_[from + 1].level == stretch_[from].level;
    stretch_[rows_] = stretch_[from];
    if (row.pair) {
      stretch_[rows_].blocks += stretch_[from + 1].blocks;
      stretch_[rows_].time += stretch_[from + 1].time;
    }
    from += row.pair ? 2 : 1;
  }
  count_ = rows_;
  length_ *= 2;
  const Stretch& last = stretch_[count_ - 1];
  open_ = last.level == level_ && last.blocks < length_;
  row_ = next_value_ = 0;
  merging_ = count_ < room_;
  if (!merging_) return;
  // Until the next flush, where each block takes kBlockSamples samples at the least.
  const uint32_t filled = (open_ ? last.blocks : 0) + pending_;
  const uint32_t blocks = filled < length_ ? length_ - filled : length_;
  const int samples = static_cast<int>(blocks < kExactBlocks ? blocks : kExactBlocks) * kBlockSamples;
  numbers_per_sample_ = 1 + rows_ * values_ / samples;
}

void ScoreTable::merge_some(int numbers) {
  while (merging_ && numbers > 0) {
    const Row& row = merged_[row_];
    const int from = row.from;
    const int end = next_value_ + numbers < values_ ? next_value_ + numbers : values_;
    for (int v = next_value_; v < end; ++v)
      put(place(row_, v), row.pair ? number(from, v) + number(from + 1, v) : number(from, v));
    report_work(100 * (end - next_value_));
    numbers -= end - next_value_;
    next_value_ = end;
    if (end < values_) return;
    next_value_ = 0;
    if (++row_ == rows_) end_merge();
  }
}

void ScoreTable::end_merge() {
  merging_ = false;
  if (held_in_new_row_) append_row();
  add_exact(held_);
}

Scaled ScoreTable::value(int s, int value) const { return long_scaled(number(s, value)); }

Scaled ScoreTable::sum(int from, int to, int value) const {
  static_assert(kMostStretches <= 256, "2^31 2^22 of each");
  constexpr int kGuard = 22;
  int largest = INT8_MIN;
  for (int s = from; s < to; ++s) {
    const ShortScaled one = number(s, value);
    if (one.mantissa != 0 && one.exponent > largest) largest = one.exponent;
  }
  int64_t sum = 0;
  for (int s = from; s < to; ++s) {
    const ShortScaled one = number(s, value);
    const int distance = largest - one.exponent;
    if (one.mantissa != 0 && distance < 62) sum += (one.mantissa * (int64_t{1} << kGuard)) >> distance;
  }
  report_work(150 + 60 * (to - from));
  return Scaled::from_int(sum, largest - kGuard);
}

}  // namespace firmware
