#include "tests/identification/hand_table.hpp"

namespace hand {
namespace {

firmware::PackedScaled packed(double value) { return firmware::pack(rig_file::to_scaled(value)); }

}  // namespace

HandTable::HandTable(int dofs, const std::vector<firmware::TermKind>& kinds,
                     const std::vector<std::vector<int>>& dofs_of_unknown) {
  configuration.dof_count = static_cast<uint8_t>(dofs);
  configuration.unknown_count = static_cast<uint8_t>(kinds.size());
  configuration.sample_period_s = rig_file::to_scaled(1e-3);
  for (size_t k = 0; k < kinds.size(); ++k) {
    firmware::Term& term = configuration.terms[configuration.term_count++];
    term.kind = kinds[k];
    term.place = static_cast<uint8_t>(kinds[k] == firmware::TermKind::kMass ? dofs_of_unknown[k][0] : k);
    term.unknown = static_cast<int8_t>(k);
  }
  firmware::RowLayout& layout = table->layout;
  layout.dof_count = configuration.dof_count;
  layout.unknown_count = configuration.unknown_count;
  uint8_t slots = 0;
  for (int i = 0; i <= firmware::kMaxDofs; ++i) {
    layout.first[i] = slots;
    for (size_t k = 0; k < kinds.size() && i < dofs; ++k)
      for (int dof : dofs_of_unknown[k])
        if (dof == i) layout.unknown[slots++] = static_cast<uint8_t>(k);
  }
  table->sample_period_s = configuration.sample_period_s;
}

void HandTable::known(firmware::TermKind kind, int place, double value) {
  firmware::Term& term = configuration.terms[configuration.term_count++];
  term.kind = kind;
  term.place = static_cast<uint8_t>(place);
  term.value = rig_file::to_scaled(value);
}

void HandTable::level(bool periodic) {
  firmware::Level& level = table->level[table->level_count++];
  level.periodic = periodic;
  level.closed = true;
}

void HandTable::batch(const std::vector<DofEntry>& dofs) {
  firmware::Level& level = table->level[table->level_count - 1];
  firmware::Batch& batch = level.batch[level.batch_count++];
  batch.samples = 100;
  for (size_t i = 0; i < dofs.size(); ++i) {
    const DofEntry& entry = dofs[i];
    firmware::BatchDof& dof = batch.dof[i];
    for (int q : {static_cast<int>(Weight::kPlain), static_cast<int>(Weight::kInstrument)}) {
      for (size_t k = 0; k < entry.columns.size(); ++k)
        batch.column[q][table->layout.first[i] + k] = packed(entry.columns[k]);
      dof.rhs[q] = packed(entry.rhs + (q == 0 ? entry.plain_rhs_change : 0.0));
      dof.kinetic_discrepancy[q] = packed(entry.kinetic);
      dof.elastic_discrepancy[q] = packed(entry.elastic);
    }
    const int x = static_cast<int>(Weight::kDisplacement);
    for (size_t k = 0; k < entry.displacement.columns.size(); ++k)
      batch.column[x][table->layout.first[i] + k] = packed(entry.displacement.columns[k]);
    dof.rhs[x] = packed(entry.displacement.rhs);
    dof.displacement_square() = packed(entry.displacement.square);
    dof.elastic_end = packed(entry.elastic_end);
    dof.velocity_square = dof.velocity_instrument = dof.weight_square = packed(entry.motion);
    dof.acceleration_square = packed(entry.acceleration_square);
  }
}

const firmware::Estimates& HandTable::identify() {
  firmware::identify(configuration, *table, *memory, *estimates);
  return *estimates;
}

}  // namespace hand
