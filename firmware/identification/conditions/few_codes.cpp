#include "firmware/identification/conditions/few_codes.hpp"

#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/identification/rows/rows.hpp"

namespace firmware {
namespace {

constexpr int kFewCodesLog2 = 4;

// Of a level: is the integral of the signal's square below that of so many codes?
bool few(const BatchTable& table, const Level& level, int dof, Quantity quantity, const SignalConfiguration& signal) {
  Scaled square;
  uint32_t samples = 0;
  for (int b = 0; b < level.batch_count; ++b) {
    report_work(100);
    const BatchDof& sums = level.batch[b].dof[dof];
    square += unpack(quantity == Quantity::kVelocity ? sums.velocity_square : sums.displacement_square());
    samples += level.batch[b].samples;
  }
  const Scaled least = scale_by_power_of_two(signal.unit_per_code, kFewCodesLog2);
  return square < least * least * table.sample_period_s * Scaled::from_int(samples);
}

bool few_in_all(const BatchTable& table, const CoreConfiguration& configuration, int dof, Quantity quantity) {
  const SignalConfiguration& signal = configuration.signals[dof][static_cast<int>(quantity)];
  if (signal.integrations == 0) return false;
  for (int l = 0; l < table.level_count; ++l)
    if (!few(table, table.level[l], dof, quantity, signal)) return false;
  return true;
}

}  // namespace

bool has_few_codes(const BatchTable& table, const CoreConfiguration& configuration, int unknown) {
  if (!kDerivesSignals || configuration.high_pass_order == 0) return false;
  const bool sums_displacements = table.layout.weight_count > static_cast<int>(Weight::kDisplacement);
  for (int dof = 0; dof < table.layout.dof_count; ++dof) {
    if (!stands_in(table.layout, dof, unknown)) continue;
    if (few_in_all(table, configuration, dof, Quantity::kVelocity) ||
        (sums_displacements && few_in_all(table, configuration, dof, Quantity::kDisplacement)))
      return true;
  }
  return false;
}

}  // namespace firmware
