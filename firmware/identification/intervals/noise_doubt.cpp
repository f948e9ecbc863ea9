#include "firmware/identification/intervals/noise_doubt.hpp"

namespace firmware {
namespace {

bool any_doubt(const CoreConfiguration& configuration) {
  for (const uint16_t doubt : configuration.motion_noise_doubt)
    if (doubt != 0) return true;
  return false;
}

// Mean power that the doubtful noise of a DOF puts into its equation: every force that the DOF's own motion makes.
Scaled doubtful_power(const CoreConfiguration& configuration, int dof, int weight, const Estimates& estimates) {
  const Scaled* noise = configuration.shared_noise[dof][weight];
  Scaled power;
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    Quantity quantity = Quantity::kAcceleration;
    if (term.kind == TermKind::kMass) {
      if (term.place != dof) continue;
    } else {
      const LinkConfiguration& link = configuration.links[term.place];
      if (link.node_a != dof && link.node_b != dof) continue;
      if (term.kind != TermKind::kViscous && term.kind != TermKind::kStiffness) continue;
      quantity = term.kind == TermKind::kViscous ? Quantity::kVelocity : Quantity::kDisplacement;
    }
    const Scaled& value = term.unknown < 0 ? term.value : estimates.parameters[term.unknown].value;
    multiply_add(power, value, noise[static_cast<int>(quantity)]);
  }
  return power * Scaled::ratio(configuration.motion_noise_doubt[dof], 1000);
}

// Over the samples that the equation counts.
Scaled counted_time(const BatchTable& table, const Batch& batch, int dof) {
  const Scaled time = table.sample_period_s * Scaled::from_int(batch.samples);
  const Scaled counted = unpack(batch.dof[dof].weight_square), all = unpack(batch.dof[dof].velocity_instrument);
  return all.is_positive() && counted.is_positive() ? time * counted / all : time;
}

// Adds what the rows of the level that is loaded give to the normal equations where their right-hand sides change so.
// A frame of its own: the caller's vectors and its row stand on the stack at different times.
[[gnu::noinline]] void add_equation(const EquationList& list, const LevelColumns& level, const Whitening& whitening,
                                    int e, WeightedFit& fit, Scaled* moment) {
  if (whitening.deviation.is_zero()) return;
  const ReducedRows& rows = fit.reduce(whitening, e, false);
  const WholeColumn change = rows.residual();
  if (!level.periodic()) {
    const Scaled weight = kScaledOne / (whitening.deviation * whitening.deviation);
    for (int j = 0; j < rows.unknowns; ++j) {
      Scaled& sum = moment[rows.unknown[j]];
      multiply_add(sum, dot(rows.column(j), change, level.batch_count()), weight);
    }
    return;
  }
  Row row;
  if (!whitened_level_row(list, level, whitening, e, row)) return;
  int64_t total = 0;
  for (int b = 0; b < level.batch_count(); ++b) total += change.value[b];
  const Scaled whitened = Scaled::from_int(total, change.exponent) / whitening.deviation;
  for (int k = 0; k < list.unknown_count; ++k) multiply_add(moment[k], row.column[k], whitened);
}

// By what the doubtful right-hand sides shift: their moments are the fit's vector. The doubt is a bound: half of it is a deviation.
[[gnu::noinline]] void widen_by(const EquationList& list, WeightedFit& fit, Estimates& estimates) {
  Scaled shift[kMaxUnknowns];
  fit.equations().apply_covariance(fit.vector(), shift);
  for (int k = 0; k < list.unknown_count; ++k) widen(estimates.parameters[k], scale_by_power_of_two(shift[k], -1));
}

}  // namespace

void add_noise_doubt(const CoreConfiguration& configuration, const EquationList& list, const BatchTable& table,
                     WeightedFit& fit, Estimates& estimates) {
  if (!kDerivesSignals || !any_doubt(configuration)) return;
  Scaled power[kMaxEquations];
  Scaled* const moment = fit.vector();
  for (int k = 0; k < list.unknown_count; ++k) moment[k] = Scaled{};
  for (int e = 0; e < list.count; ++e)
    power[e] =
        doubtful_power(configuration, list.equation[e].dof, static_cast<int>(list.equation[e].weight), estimates);
  for (int l = 0; l < table.level_count; ++l) {
    LevelColumns& level = fit.load_level(l, false);
    level.load_changes(
        [&](const Batch& batch, int e) { return power[e] * counted_time(table, batch, list.equation[e].dof); });
    for (int e = 0; e < list.count; ++e) add_equation(list, level, fit.whitening(l, e), e, fit, moment);
  }
  widen_by(list, fit, estimates);
}

}  // namespace firmware
