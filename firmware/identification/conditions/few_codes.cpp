#include "firmware/identification/conditions/few_codes.hpp"

#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/identification/rows/rows.hpp"

namespace firmware {
namespace {

constexpr int kFewCodesLog2 = 4;

Scaled square_of(const BatchDof& sums, Quantity quantity) {
  if (quantity == Quantity::kDisplacement) return unpack(sums.displacement_square());
  return unpack(quantity == Quantity::kVelocity ? sums.velocity_square : sums.acceleration_square);
}

// Of a level: is the integral of the signal's square below that of so many codes?
bool few(const BatchTable& table, const Level& level, int dof, Quantity quantity, const Scaled& unit) {
  Scaled square;
  uint32_t samples = 0;
  for (int b = 0; b < level.batch_count; ++b) {
    report_work(100);
    square += square_of(level.batch[b].dof[dof], quantity);
    samples += level.batch[b].samples;
  }
  const Scaled least = scale_by_power_of_two(unit, kFewCodesLog2);
  return square < least * least * table.sample_period_s * Scaled::from_int(samples);
}

bool few_in_all(const BatchTable& table, const CoreConfiguration& configuration, int dof, Quantity quantity) {
  const SignalConfiguration& signal = configuration.signals[dof][static_cast<int>(quantity)];
  if (!signal.derived) return false;
  for (int l = 0; l < table.level_count; ++l)
    if (!few(table, table.level[l], dof, quantity, signal.unit_per_code)) return false;
  return true;
}

// An acceleration's square is kept beside an instrument, a displacement's beside the displacement rows.
bool few_in_any(const BatchTable& table, const CoreConfiguration& configuration, int dof) {
  const int weights = table.layout.weight_count;
  return few_in_all(table, configuration, dof, Quantity::kVelocity) ||
         (weights > static_cast<int>(Weight::kInstrument) &&
          few_in_all(table, configuration, dof, Quantity::kAcceleration)) ||
         (weights > static_cast<int>(Weight::kDisplacement) &&
          few_in_all(table, configuration, dof, Quantity::kDisplacement));
}

}  // namespace

bool has_few_codes(const BatchTable& table, const CoreConfiguration& configuration, int unknown) {
  if (!kDerivesSignals) return false;
  for (int dof = 0; dof < table.layout.dof_count; ++dof)
    if (stands_in(table.layout, dof, unknown) && few_in_any(table, configuration, dof)) return true;
  return false;
}

}  // namespace firmware
