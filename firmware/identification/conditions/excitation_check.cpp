#include "firmware/identification/conditions/excitation_check.hpp"

#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/vocabulary/effect_table.hpp"

namespace firmware {
namespace {

// Work of the unknown's unit force on all its DOFs in one batch.
Scaled unit_work(const RowLayout& layout, const Batch& batch, Weight weight, int unknown) {
  Scaled work;
  for (int n = 0; n < layout.first[layout.dof_count]; ++n)
    if (layout.unknown[n] == unknown) work += unpack(batch.column[static_cast<int>(weight)][n]);
  return work;
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

Weight weight_of(const EquationList& list, const Term& term) {
  if (kHasDisplacementRows && list.displacement && is_conservative(term.kind)) return Weight::kDisplacement;
  return list.instrument ? Weight::kInstrument : Weight::kPlain;
}

// Of the term's unit force in one level; magnitude: without the signs of the batches.
struct Work_J {
  Scaled sum, magnitude;
};
Work_J work_in(const EquationList& list, const BatchTable& table, const Level& level, const Term& term) {
  const Weight weight = weight_of(list, term);
  Work_J total;
  for (int b = 0; b < level.batch_count; ++b) {
    report_work(200 + 10 * table.layout.first[table.layout.dof_count]);
    const Scaled work = unit_work(table.layout, level.batch[b], weight, term.unknown);
    total.sum += work;
    total.magnitude += abs(work);
  }
  return total;
}

bool adds_up(const EquationList& list, const BatchTable& table, const Term& term) {
  for (int l = 0; l < table.level_count; ++l) {
    const Work_J work = work_in(list, table, table.level[l], term);
    if (!work.magnitude.is_zero() && scale_by_power_of_two(abs(work.sum), 1) > work.magnitude) return true;
  }
  return false;
}

bool reaches_beyond(const ParameterEstimate& parameter, const Scaled& per_unit, const Scaled& all) {
  return scale_by_power_of_two(parameter.ci95_high - parameter.ci95_low, -1) * per_unit > all;
}

bool is_damping(const Term& term) {
  return term.kind != TermKind::kMass && has_one_sign(term) && !is_conservative(term.kind);
}

// The signs of a mass's and a spring's work tell nothing of a motion about another place than zero (an arm held out, a shaft that
// runs on). What dissipates at the link tells that it moves; of a mass a link to the ground, as one to a neighbour may move by that alone.
bool dissipates(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                const Term& what) {
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& other = configuration.terms[t];
    if (other.unknown < 0 || !is_damping(other)) continue;
    const LinkConfiguration& link = configuration.links[other.place];
    const bool there = what.kind == TermKind::kMass ? link.node_a == what.place && link.node_b == kGroundNode
                                                    : other.place == what.place;
    if (there && adds_up(list, table, other)) return true;
  }
  return false;
}

}  // namespace

bool is_undetermined(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                     int unknown, const Estimates& estimates) {
  const Term* term = term_of(configuration, unknown);
  if (term == nullptr) return false;
  const ParameterEstimate& own = estimates.parameters[unknown];
  if (!reaches_beyond(own, kScaledOne, abs(own.value))) return false;  // nor beyond what it is a part of
  if (kHasDisplacementRows && (term->kind == TermKind::kMass || term->kind == TermKind::kStiffness)) return true;
  if (!is_damping(*term)) return false;
  Scaled all, own_work;
  for (int pass = 0; pass < 2; ++pass) {
    Scaled known;
    for (int t = 0; t < configuration.term_count; ++t) {
      const Term& other = configuration.terms[t];
      if (!is_damping(other) || other.place != term->place) continue;
      if (other.unknown < 0 && !other.value.is_zero()) return false;
      if (other.unknown < 0) continue;
      Scaled work;
      for (int l = 0; l < table.level_count; ++l) work += abs(work_in(list, table, table.level[l], other).sum);
      if (other.unknown == unknown) own_work = work;
      const ParameterEstimate& parameter = estimates.parameters[other.unknown];
      if (pass == 0 || !reaches_beyond(parameter, work, all)) multiply_add(known, abs(parameter.value), work);
    }
    all = known;
  }
  return reaches_beyond(own, own_work, all);
}

bool is_excited(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                int unknown) {
  const Term* term = term_of(configuration, unknown);
  if (term == nullptr) return false;
  if (has_one_sign(*term))
    return adds_up(list, table, *term) ||
           (kHasDisplacementRows && !is_damping(*term) && dissipates(list, table, configuration, *term));
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
