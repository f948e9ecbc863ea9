#include "firmware/warrant/score_table.hpp"

namespace firmware {

void ScoreTable::configure(int values) {
  values_ = values;
  room_ = values > 0 ? kWarrantNumbers / values : 0;
  if (room_ > kMostStretches) room_ = kMostStretches;
  clear();
}

void ScoreTable::clear() {
  count_ = level_ = 0;
  open_ = false;
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

void ScoreTable::flush() {
  if (pending_ == 0) return;
  if (!open_) {
    if (count_ == room_) merge();
    if (count_ == room_) return;  // more levels than stretches: what comes is not tested
  }
  if (!open_) {
    stretch_[count_] = Stretch{static_cast<uint8_t>(level_), 0, 0};
    for (int v = 0; v < values_; ++v) number_[count_ * values_ + v] = PackedScaled{};
    ++count_;
    open_ = true;
  }
  Stretch& last = stretch_[count_ - 1];
  for (int v = 0; v < values_; ++v) {
    if (current_[v] != 0) add_to(count_ - 1, v, Scaled::from_int(current_[v]));
    current_[v] = 0;
  }
  last.blocks += pending_;
  last.time += pending_time_;
  pending_ = 0;
  pending_time_ = 0;
  if (last.blocks >= length_) open_ = false;
}

// Neighbours of the same level; one that is left over at a level's end stays as it is, the last one goes on.
void ScoreTable::merge() {
  int to = 0;
  for (int from = 0; from < count_; ++to) {
    const bool pair = from + 1 < count_ && stretch_[from + 1].level == stretch_[from].level;
    stretch_[to] = stretch_[from];
    if (to != from)
      for (int v = 0; v < values_; ++v) number_[to * values_ + v] = number_[from * values_ + v];
    if (pair) {
      stretch_[to].blocks += stretch_[from + 1].blocks;
      stretch_[to].time += stretch_[from + 1].time;
      for (int v = 0; v < values_; ++v) add_to(to, v, value(from + 1, v));
    }
    from += pair ? 2 : 1;
  }
  count_ = to;
  length_ *= 2;
  const Stretch& last = stretch_[count_ - 1];
  open_ = last.level == level_ && last.blocks < length_;
}

}  // namespace firmware
