#include "firmware/energy/batch_collector.hpp"

namespace firmware {
namespace {

void add_packed(PackedScaled& a, PackedScaled b) { a = pack(unpack(a) + unpack(b)); }

// A level of one cycle still gives enough batches to measure their scatter; longer ones merge.
uint32_t first_batch_length(const WindowConfiguration& window) {
  uint32_t length = window.batch_samples;
  if (length == 0)
    length = window.mode == WindowMode::kWholeCycles
                 ? window.cycle_samples_numerator / (16 * window.cycle_samples_denominator)
                 : static_cast<uint32_t>(kBlockSamples);
  if (length < 8) return 8;
  return length > kMaxBatchSamples ? kMaxBatchSamples : length;
}

}  // namespace

void accumulate(Batch& a, const Batch& b, const RowLayout& layout) {
  a.samples += b.samples;
  const int slots = layout.first[kMaxDofs];
  for (int q = 0; q < kWeights; ++q)
    for (int s = 0; s < slots; ++s) add_packed(a.column[q][s], b.column[q][s]);
  for (int i = 0; i < layout.dof_count; ++i) {
    for (int q = 0; q < kWeights; ++q) {
      add_packed(a.dof[i].rhs[q], b.dof[i].rhs[q]);
      add_packed(a.dof[i].kinetic_discrepancy[q], b.dof[i].kinetic_discrepancy[q]);
      add_packed(a.dof[i].elastic_discrepancy[q], b.dof[i].elastic_discrepancy[q]);
    }
    add_packed(a.dof[i].kinetic_end, b.dof[i].kinetic_end);
    add_packed(a.dof[i].elastic_end, b.dof[i].elastic_end);
    add_packed(a.dof[i].velocity_square, b.dof[i].velocity_square);
    add_packed(a.dof[i].velocity_instrument, b.dof[i].velocity_instrument);
    add_packed(a.dof[i].acceleration_square, b.dof[i].acceleration_square);
  }
}

void BatchCollector::clear(const CoreConfiguration& configuration, const RowLayout& layout) {
  table_.layout = layout;
  table_.sample_period_s = configuration.sample_period_s;
  table_.level_count = 0;
  first_length_ = first_batch_length(configuration.window);
  periodic_ = configuration.window.mode == WindowMode::kWholeCycles;
  open_ = refused_ = false;
}

void BatchCollector::begin_level() {
  end_level();
  if (table_.level_count == kMaxLevels) {
    refused_ = true;
    return;
  }
  Level& level = table_.level[table_.level_count++];
  level.batch_count = 0;
  level.merges = 0;
  level.periodic = periodic_;
  level.saturated = level.closed = false;
  pending_ = Batch{};
  open_ = true;
}

void BatchCollector::append(const Batch& batch) {
  Level& level = table_.level[table_.level_count - 1];
  if (level.batch_count == kMaxBatches) {
    for (int b = 0; b < kMaxBatches / 2; ++b) {
      level.batch[b] = level.batch[2 * b];
      accumulate(level.batch[b], level.batch[2 * b + 1], table_.layout);
    }
    level.batch_count = kMaxBatches / 2;
    ++level.merges;
  }
  level.batch[level.batch_count++] = batch;
}

uint32_t BatchCollector::batch_length() const {
  if (!open_) return first_length_;
  const Level& level = table_.level[table_.level_count - 1];
  const bool full = level.batch_count == kMaxBatches;  // the next one will merge the others first and double the length
  return first_length_ << (level.merges + (full ? 1 : 0));
}

void BatchCollector::add(const Batch& batch) {
  if (!open_) return;
  if (pending_.samples == 0) {
    pending_ = batch;
  } else {
    accumulate(pending_, batch, table_.layout);
  }
  if (pending_.samples < batch_length()) return;
  append(pending_);
  pending_ = Batch{};
}

void BatchCollector::mark_saturated() {
  if (open_) table_.level[table_.level_count - 1].saturated = true;
}

void BatchCollector::end_level() {
  if (!open_) return;
  if (pending_.samples > 0) append(pending_);
  table_.level[table_.level_count - 1].closed = true;
  pending_ = Batch{};
  open_ = false;
}

}  // namespace firmware
