#include "firmware/identification/conditions/slow_motion.hpp"

#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/identification/rows/rows.hpp"

namespace firmware {
namespace {

bool slow(const Level& level, int dof, Scaled half_time_constant_s) {
  Scaled change, velocity_square;
  for (int b = 0; b < level.batch_count; ++b) {
    report_work(200);
    change += abs(unpack(level.batch[b].dof[dof].elastic_end));
    velocity_square += unpack(level.batch[b].dof[dof].velocity_square);
  }
  return change > half_time_constant_s * velocity_square;
}

}  // namespace

bool filters_alone_move(const BatchTable& table, const CoreConfiguration& configuration, int unknown) {
  if (!kDerivesSignals || configuration.high_pass_order == 0) return false;
  const Scaled half_time_constant_s =
      scale_by_power_of_two(configuration.sample_period_s, configuration.high_pass_shift - 1);
  for (int dof = 0; dof < table.layout.dof_count; ++dof) {
    const SignalConfiguration& displacement = configuration.signals[dof][static_cast<int>(Quantity::kDisplacement)];
    if (displacement.integrations == 0 || !stands_in(table.layout, dof, unknown)) continue;
    for (int l = 0; l < table.level_count; ++l)
      if (slow(table.level[l], dof, half_time_constant_s)) return true;
  }
  return false;
}

}  // namespace firmware
