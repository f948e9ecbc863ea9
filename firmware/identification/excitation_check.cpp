#include "firmware/identification/excitation_check.hpp"

#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/vocabulary/effect_table.hpp"

namespace firmware {
namespace {

// Work of the unknown's unit force on all its DOFs in one batch.
Scaled unit_work(const RowLayout& layout, const Batch& batch, Weight weight, int unknown) {
  Scaled work;
  for (int n = 0; n < layout.first[layout.dof_count]; ++n)
    if (layout.unknown[n] == unknown) work = work + unpack(batch.column[static_cast<int>(weight)][n]);
  return work;
}

const Term* term_of(const CoreConfiguration& configuration, int unknown) {
  for (int t = 0; t < configuration.term_count; ++t)
    if (configuration.terms[t].unknown == unknown) return &configuration.terms[t];
  return nullptr;
}

// A bit per TermKind, taken from the vocabulary when compiling.
constexpr uint32_t terms_of_one_sign() {
  uint32_t bits = 0;
  for (int t = 0; t < kTermKinds; ++t)
    if (row_of(static_cast<TermKind>(t)).nature.work == Work::kOneSign) bits |= uint32_t{1} << t;
  return bits;
}
constexpr uint32_t kOneSign = terms_of_one_sign();
bool has_one_sign(const Term& term) { return (kOneSign >> static_cast<int>(term.kind) & 1) != 0; }

bool adds_up(const EquationList& list, const BatchTable& table, const Term& term) {
  Weight weight = list.instrument ? Weight::kInstrument : Weight::kPlain;
  if (list.displacement && is_conservative(term.kind)) weight = Weight::kDisplacement;
  for (int l = 0; l < table.level_count; ++l) {
    Scaled sum, magnitude;
    for (int b = 0; b < table.level[l].batch_count; ++b) {
      report_work(200 + 10 * table.layout.first[table.layout.dof_count]);
      const Scaled work = unit_work(table.layout, table.level[l].batch[b], weight, term.unknown);
      sum = sum + work;
      magnitude = magnitude + abs(work);
    }
    if (!magnitude.is_zero() && scale_by_power_of_two(abs(sum), 1) > magnitude) return true;
  }
  return false;
}

}  // namespace

bool is_excited(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                int unknown) {
  const Term* term = term_of(configuration, unknown);
  if (term == nullptr) return false;
  if (has_one_sign(*term)) return adds_up(list, table, *term);
  bool judged = false;
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& other = configuration.terms[t];
    if (other.unknown < 0 || other.place != term->place || other.kind == TermKind::kMass || !has_one_sign(other))
      continue;
    if (adds_up(list, table, other)) return true;
    judged = true;
  }
  return !judged;
}

}  // namespace firmware
