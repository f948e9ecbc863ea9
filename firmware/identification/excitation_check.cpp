#include "firmware/identification/excitation_check.hpp"

namespace firmware {
namespace {

// Work of the unknown's unit force on all its DOFs in one batch.
Scaled unit_work(const RowLayout& layout, const Batch& batch, Weight weight, int unknown) {
  Scaled work;
  for (int n = 0; n < layout.first[layout.dof_count]; ++n)
    if (layout.unknown[n] == unknown) work = work + unpack(batch.column[static_cast<int>(weight)][n]);
  return work;
}

bool conservative(const CoreConfiguration& configuration, int unknown) {
  for (int t = 0; t < configuration.term_count; ++t)
    if (configuration.terms[t].unknown == unknown) return is_conservative(configuration.terms[t].kind);
  return false;
}

}  // namespace

bool is_excited(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                int unknown) {
  Weight weight = list.instrument ? Weight::kInstrument : Weight::kPlain;
  if (list.displacement && conservative(configuration, unknown)) weight = Weight::kDisplacement;
  for (int l = 0; l < table.level_count; ++l) {
    Scaled sum, magnitude;
    for (int b = 0; b < table.level[l].batch_count; ++b) {
      const Scaled work = unit_work(table.layout, table.level[l].batch[b], weight, unknown);
      sum = sum + work;
      magnitude = magnitude + abs(work);
    }
    if (!magnitude.is_zero() && scale_by_power_of_two(abs(sum), 1) > magnitude) return true;
  }
  return false;
}

}  // namespace firmware
