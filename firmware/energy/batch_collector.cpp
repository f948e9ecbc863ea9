#include "firmware/energy/batch_collector.hpp"

namespace firmware {
namespace {

void add_packed(PackedScaled& a, PackedScaled b) { a = pack(unpack(a) + unpack(b)); }

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
  const WindowConfiguration& window = configuration.window;
  table_.layout = layout;
  table_.sample_period_s = configuration.sample_period_s;
  table_.level_count = 0;
  periodic_ = window.mode == WindowMode::kWholeCycles && window.cycle_samples_numerator > 0;
  unit_denominator_ = 1;
  unit_numerator_ = window.batch_samples == 0 ? kBlockSamples : window.batch_samples;
  if (unit_numerator_ < 8) unit_numerator_ = 8;
  if (unit_numerator_ > kMaxBatchSamples) unit_numerator_ = kMaxBatchSamples;
  units_per_cycle_ = 16;
  if (periodic_) {
    // At least 8 samples, at most 1023 and a rounded one.
    while (units_per_cycle_ > 1 &&
           window.cycle_samples_numerator < 8 * units_per_cycle_ * window.cycle_samples_denominator)
      units_per_cycle_ /= 2;
    while (window.cycle_samples_numerator >
           (kMaxBatchSamples - 1) * units_per_cycle_ * window.cycle_samples_denominator)
      units_per_cycle_ *= 2;
    unit_numerator_ = window.cycle_samples_numerator;
    unit_denominator_ = window.cycle_samples_denominator * units_per_cycle_;
  }
  open_ = refused_ = false;
}

void BatchCollector::begin_level() {
  end_level();
  if (table_.level_count == kMaxLevels) {
    refused_ = true;
    return;
  }
  ++table_.level_count;
  level().batch_count = 0;
  level().merges = 0;
  level().periodic = periodic_;
  level().saturated = level().closed = false;
  pending_ = Batch{};
  pending_units_ = table_units_ = 0;
  open_ = true;
  incomplete_ = false;
}

uint32_t BatchCollector::unit_end(uint32_t unit) const {
  const uint64_t twice = 2 * static_cast<uint64_t>(unit) * unit_numerator_ + unit_denominator_;
  return static_cast<uint32_t>(twice / (2 * static_cast<uint64_t>(unit_denominator_)));  // nearest sample
}

uint32_t BatchCollector::units_wanted() const {
  const bool full =
      level().batch_count == kMaxBatches;  // the next one merges the others first: batches are twice as long
  const uint32_t missing = (uint32_t{1} << (level().merges + (full ? 1 : 0))) - pending_units_;
  const uint32_t most = (kMaxBatchSamples - 1) * unit_denominator_ / unit_numerator_;
  return most == 0 ? 1 : (missing < most ? missing : most);
}

void BatchCollector::append(const Batch& batch) {
  if (level().batch_count == kMaxBatches) {
    for (int b = 0; b < kMaxBatches / 2; ++b) {
      level().batch[b] = level().batch[2 * b];
      accumulate(level().batch[b], level().batch[2 * b + 1], table_.layout);
    }
    level().batch_count = kMaxBatches / 2;
    ++level().merges;
  }
  level().batch[level().batch_count++] = batch;
}

void BatchCollector::add(const Batch& batch, uint32_t units) {
  if (!open_) return;
  if (pending_.samples == 0) {
    pending_ = batch;
  } else {
    accumulate(pending_, batch, table_.layout);
  }
  pending_units_ += units;
  incomplete_ = units == 0;
  const bool full = level().batch_count == kMaxBatches;
  if (pending_units_ < (uint32_t{1} << (level().merges + (full ? 1 : 0)))) return;
  append(pending_);
  table_units_ += pending_units_;
  pending_ = Batch{};
  pending_units_ = 0;
}

void BatchCollector::mark_saturated() {
  if (open_) level().saturated = true;
}

void BatchCollector::keep_whole_cycles() {
  const uint32_t total = table_units_ + pending_units_;
  if (total < units_per_cycle_) return;
  const uint32_t excess = total % units_per_cycle_;
  if (excess == 0 && !incomplete_) return;
  if (table_units_ < units_per_cycle_) return;
  pending_ = Batch{};
  const uint32_t batch_units = uint32_t{1} << level().merges;
  while (table_units_ % units_per_cycle_ != 0 && level().batch_count > 1) {
    --level().batch_count;
    table_units_ -= batch_units;
  }
}

void BatchCollector::end_level() {
  if (!open_) return;
  if (periodic_) keep_whole_cycles();
  if (pending_.samples > 0) append(pending_);
  level().closed = true;
  pending_ = Batch{};
  pending_units_ = 0;
  open_ = false;
}

}  // namespace firmware
