#include "firmware/energy/batch_collector.hpp"

#include "firmware/fixed_point/wide.hpp"

namespace firmware {
namespace {

constexpr int kCountBits = 40;  // of samples since a level's start: a year at 20 kHz
constexpr int kDofNumbers = sizeof(BatchDof) / sizeof(PackedScaled);

// A batch in parts: the columns of a weight, then the numbers of a DOF.
int part_count(const RowLayout& layout) { return layout.weight_count + layout.dof_count; }
struct Part {
  PackedScaled* number;
  int count;
};
Part part_of(Batch& batch, const RowLayout& layout, int part) {
  if (part < layout.weight_count) return {batch.column[part], layout.first[kMaxDofs]};
  return {batch.dof[part - layout.weight_count].rhs, kDofNumbers};  // the first of its numbers, which are alike
}

// sum = a + b; sum may be one of them. What nobody asks for is 0.
void add_part(Batch& sum, Batch& a, Batch& b, const RowLayout& layout, int part) {
  const Part to = part_of(sum, layout, part), one = part_of(a, layout, part), other = part_of(b, layout, part);
  for (int i = 0; i < to.count; ++i) {
    const PackedScaled left = one.number[i], right = other.number[i];
    to.number[i] = right.bits == 0 ? left : left.bits == 0 ? right : left + right;
  }
}

void copy_part(Batch& to, Batch& from, const RowLayout& layout, int part) {
  const Part copy = part_of(to, layout, part), original = part_of(from, layout, part);
  for (int i = 0; i < copy.count; ++i) copy.number[i] = original.number[i];
}

}  // namespace

void accumulate(Batch& a, const Batch& b, const RowLayout& layout) {
  a.samples += b.samples;
  for (int part = 0; part < part_count(layout); ++part) add_part(a, a, const_cast<Batch&>(b), layout, part);
}

void copy_used(Batch& to, const Batch& from, const RowLayout& layout) {
  to.samples = from.samples;
  for (int part = 0; part < part_count(layout); ++part) copy_part(to, const_cast<Batch&>(from), layout, part);
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
    const uint64_t of_cycle = window.cycle_samples_denominator;
    while (units_per_cycle_ > 1 && window.cycle_samples_numerator < 8 * units_per_cycle_ * of_cycle)
      units_per_cycle_ /= 2;
    while (window.cycle_samples_numerator > (kMaxBatchSamples - 1) * units_per_cycle_ * of_cycle) units_per_cycle_ *= 2;
    unit_numerator_ = window.cycle_samples_numerator;
    unit_denominator_ = window.cycle_samples_denominator * units_per_cycle_;
  }
  open_ = refused_ = merging_ = false;
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
  pending_.samples = 0;
  pending_units_ = table_units_ = 0;
  open_ = true;
  incomplete_ = false;
}

uint32_t BatchCollector::unit_end(uint32_t unit) const {
  if (unit_denominator_ == 1) return unit * unit_numerator_;
  const uint64_t twice = 2 * static_cast<uint64_t>(unit) * unit_numerator_ + unit_denominator_;
  return static_cast<uint32_t>(
      short_quotient(twice, 2 * static_cast<uint64_t>(unit_denominator_), kCountBits));  // nearest sample
}

// As many units as the denominator says are the numerator's samples, exactly. With 2^28 units, of up to 1023 samples each, the
// products of unit_end() are below 2^62 and the samples below 2^40.
void BatchCollector::count_anew(uint32_t& units, uint32_t& samples) const {
  constexpr uint32_t kMostUnits = 1u << 28;
  if (units < kMostUnits) return;
  const uint32_t times = units / unit_denominator_;
  units -= times * unit_denominator_;
  samples -= times * unit_numerator_;
}

// With the table full (or just being merged) batches are twice as long.
uint32_t BatchCollector::batch_units() const {
  const bool doubled = merging_ || level().batch_count == kMaxBatches;
  return uint32_t{1} << (level().merges + (doubled ? 1 : 0));
}

uint32_t BatchCollector::units_wanted(uint32_t units) const {
  uint32_t missing = batch_units() - pending_units_;
  if (units > 0 && units < missing) {
    missing -= units;
  } else if (units > 0) {  // the batch goes into the table, after a merge that may be under way
    const int merges = level().merges + (merging_ ? 1 : 0);
    const int count = merging_ ? kMaxBatches / 2 + 1 : level().batch_count;
    missing = uint32_t{1} << (merges + (count + 1 >= kMaxBatches ? 1 : 0));
  }
  const uint32_t most = (kMaxBatchSamples - 1) * unit_denominator_ / unit_numerator_;
  return most == 0 ? 1 : (missing < most ? missing : most);
}

void BatchCollector::append(const Batch& batch) {
  settle();
  if (level().batch_count < kMaxBatches) {
    copy_used(level().batch[level().batch_count++], batch, table_.layout);
    return;
  }
  copy_used(held_, batch, table_.layout);
  merging_ = true;
  merged_ = part_ = 0;
  const int parts = kMaxBatches / 2 * part_count(table_.layout);
  const uint32_t samples = unit_end(batch_units());  // until the next one comes; two of a block's are left out
  parts_per_sample_ = 1 + parts / static_cast<int>(samples > 4 ? samples - samples / 4 : 1);
}

void BatchCollector::merge_part() {
  Batch& pair = level().batch[merged_];
  Batch &first = level().batch[2 * merged_], &second = level().batch[2 * merged_ + 1];
  add_part(pair, first, second, table_.layout, part_);
  if (++part_ < part_count(table_.layout)) return;
  part_ = 0;
  pair.samples = first.samples + second.samples;
  if (++merged_ < kMaxBatches / 2) return;
  merging_ = false;
  ++level().merges;
  level().batch_count = kMaxBatches / 2;
  copy_used(level().batch[level().batch_count++], held_, table_.layout);
}

void BatchCollector::merge_some() {
  for (int i = 0; i < parts_per_sample_ && merging_; ++i) merge_part();
}

void BatchCollector::settle() {
  while (merging_) merge_part();
}

void BatchCollector::add(const Batch& batch, uint32_t units) {
  if (!open_) return;
  if (pending_.samples == 0 && units >= batch_units()) {  // whole by itself
    incomplete_ = false;
    append(batch);
    table_units_ += units;
    return;
  }
  if (pending_.samples == 0) {
    copy_used(pending_, batch, table_.layout);
  } else {
    accumulate(pending_, batch, table_.layout);
  }
  pending_units_ += units;
  incomplete_ = units == 0;
  // Units that a gap cuts off count as samples: where gaps are frequent none is whole.
  const bool enough = !periodic_ && pending_.samples >= unit_end(batch_units());
  if (pending_units_ < batch_units() && !enough) return;
  append(pending_);
  table_units_ += pending_units_;
  pending_.samples = 0;
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
  pending_.samples = 0;
  const uint32_t batch_units = uint32_t{1} << level().merges;
  while (table_units_ % units_per_cycle_ != 0 && level().batch_count > 1) {
    --level().batch_count;
    table_units_ -= batch_units;
  }
}

void BatchCollector::end_level() {
  if (!open_) return;
  settle();
  if (periodic_) keep_whole_cycles();
  if (pending_.samples > 0) append(pending_);
  settle();
  level().closed = true;
  pending_.samples = 0;
  pending_units_ = 0;
  open_ = false;
}

}  // namespace firmware
