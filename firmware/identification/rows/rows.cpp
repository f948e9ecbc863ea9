#include "firmware/identification/rows/rows.hpp"

#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/vocabulary/effect_table.hpp"

namespace firmware {
namespace {

// A bit per TermKind, taken from the vocabulary when compiling: the table's words stay out of the image.
constexpr uint32_t conservative_terms() {
  uint32_t bits = 0;
  for (int t = 0; t < kTermKinds; ++t)
    if (row_of(static_cast<TermKind>(t)).nature.conservative) bits |= uint32_t{1} << t;
  return bits;
}
constexpr uint32_t kConservativeTerms = conservative_terms();
static_assert(kTermKinds <= 32, "a bit for each kind of term");

bool has_rows(const BatchTable& table, Weight weight) {
  const int q = static_cast<int>(weight) % kWeights;
  for (int l = 0; l < table.level_count; ++l) {
    const Level& level = table.level[l];
    for (int b = 0; b < level.batch_count; ++b, report_work(10 * table.layout.first[table.layout.dof_count]))
      for (int n = 0; n < table.layout.first[table.layout.dof_count]; ++n)
        if (level.batch[b].column[q][n].bits != 0) return true;
  }
  return false;
}

}  // namespace

bool stands_in(const RowLayout& layout, int dof, int unknown) {
  for (int n = layout.first[dof]; n < layout.first[dof + 1]; ++n)
    if (layout.unknown[n] == unknown) return true;
  return false;
}

bool is_conservative(TermKind kind) { return (kConservativeTerms >> static_cast<int>(kind) & 1) != 0; }

namespace {

// The steeper of two signals is the slope of what the flatter one is made of. Integrals have a high-pass: what their discrepancies hold is
// slow noise that they have kept.
bool is_slope(const CoreConfiguration& configuration, int dof, Quantity flat, Quantity steep) {
  if (configuration.fuses(dof)) return false;
  const SignalConfiguration& of = configuration.signals[dof][static_cast<int>(steep)];
  return of.derived && of.source <= static_cast<int>(flat) &&
         of.source == configuration.signals[dof][static_cast<int>(flat)].source;
}

uint8_t discrepancies_of_one_channel(const CoreConfiguration& configuration, int dof) {
  const bool kinetic = is_slope(configuration, dof, Quantity::kVelocity, Quantity::kAcceleration);
  const bool elastic = is_slope(configuration, dof, Quantity::kDisplacement, Quantity::kVelocity);
  return static_cast<uint8_t>((kinetic ? 1 : 0) | (elastic ? 2 : 0) | (kinetic && elastic ? 4 : 0));
}

}  // namespace

EquationList list_equations(const CoreConfiguration& configuration, const BatchTable& table) {
  EquationList list;
  list.dof_count = configuration.dof_count;
  list.unknown_count = configuration.unknown_count;
  list.instrument = has_rows(table, Weight::kInstrument);
  for (int t = 0; kHasDisplacementRows && t < configuration.term_count; ++t)
    if (configuration.terms[t].unknown >= 0 && is_conservative(configuration.terms[t].kind)) list.displacement = true;
  if (!kHasDisplacementRows || !has_rows(table, Weight::kDisplacement)) list.displacement = false;
  const Weight velocity = list.instrument ? Weight::kInstrument : Weight::kPlain;
  for (int i = 0; i < list.dof_count; ++i) list.equation[list.count++] = {static_cast<uint8_t>(i), velocity};
  if (kHasDisplacementRows && list.displacement)
    for (int i = 0; i < list.dof_count; ++i)
      list.equation[list.count++] = {static_cast<uint8_t>(i), Weight::kDisplacement};

  for (int i = 0; i < list.dof_count; ++i) list.neighbours[i] = uint32_t{1} << i;
  for (int i = 0; kDerivesSignals && i < list.dof_count; ++i)
    list.of_one_channel[kDerivesSignals ? i : 0] = discrepancies_of_one_channel(configuration, i);
  for (int l = 0; l < configuration.link_count; ++l) {
    const int a = configuration.links[l].node_a, b = configuration.links[l].node_b;
    if (a >= list.dof_count || b >= list.dof_count) continue;
    list.neighbours[a] |= uint32_t{1} << b;
    list.neighbours[b] |= uint32_t{1} << a;
  }
  return list;
}

void clear_row(int unknowns, Row& row) {
  for (int k = 0; k < unknowns; ++k) row.column[k] = Scaled{};
  row.rhs = Scaled{};
}

void add_batch_row(const RowLayout& layout, const Batch& batch, Equation equation, const Scaled& factor, Row& row) {
  const int q = static_cast<int>(equation.weight);
  for (int n = layout.first[equation.dof]; n < layout.first[equation.dof + 1]; ++n) {
    Scaled& column = row.column[layout.unknown[n]];
    multiply_add(column, factor, unpack(batch.column[q][n]));
  }
  multiply_add(row.rhs, factor, unpack(batch.dof[equation.dof].rhs[q]));
}

Scaled batch_residual(const RowLayout& layout, const Batch& batch, Equation equation, const Scaled* parameters) {
  const int q = static_cast<int>(equation.weight);
  Scaled residual = unpack(batch.dof[equation.dof].rhs[q]);
  for (int n = layout.first[equation.dof]; n < layout.first[equation.dof + 1]; ++n)
    multiply_subtract(residual, unpack(batch.column[q][n]), parameters[layout.unknown[n]]);
  return residual;
}

Scaled displacement_share(const Level* level, int levels, int dof) {
  Scaled displacement, velocity;
  for (int l = 0; l < levels; ++l)
    for (int b = 0; b < level[l].batch_count; ++b) {
      const BatchDof& batch = level[l].batch[b].dof[dof];
      displacement += unpack(batch.displacement_square());
      velocity += unpack(batch.velocity_square);
    }
  return displacement.is_positive() && velocity.is_positive() ? displacement / velocity : kScaledOne;
}

bool moves(const BatchDof& dof, bool instrument, const Scaled& least_motion) {
  const Scaled energy = unpack(dof.velocity_square);
  if (energy <= least_motion) return false;
  if (!instrument) return true;
  const Scaled clean = unpack(dof.velocity_instrument);
  return energy - clean < clean;
}

}  // namespace firmware
