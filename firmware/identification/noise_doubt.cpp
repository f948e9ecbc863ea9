#include "firmware/identification/noise_doubt.hpp"

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
    const Scaled value = term.unknown < 0 ? term.value : estimates.parameters[term.unknown].value;
    power = power + value * noise[static_cast<int>(quantity)];
  }
  return power * Scaled::ratio(configuration.motion_noise_doubt[dof], 1000);
}

// Over the samples that the equation counts.
Scaled counted_time(const BatchTable& table, const Batch& batch, int dof) {
  const Scaled time = table.sample_period_s * Scaled::from_int(batch.samples);
  const Scaled counted = unpack(batch.dof[dof].weight_square), all = unpack(batch.dof[dof].velocity_instrument);
  return all > Scaled{} && counted > Scaled{} ? time * counted / all : time;
}

class Doubt {
 public:
  Doubt(const CoreConfiguration& configuration, const EquationList& list, const BatchTable& table, WeightedFit& fit,
        const Estimates& estimates)
      : list_(list), table_(table), fit_(fit) {
    for (int e = 0; e < list.count; ++e)
      power_[e] =
          doubtful_power(configuration, list.equation[e].dof, static_cast<int>(list.equation[e].weight), estimates);
  }
  void add_level(int l) {
    const LevelObservables& level = fit_.load_level(l);
    for (int e = 0; e < list_.count; ++e) add_equation(level, l, e);
  }
  const Scaled& shift(int unknown) const { return shift_[unknown]; }

 private:
  void add_equation(const LevelObservables& level, int l, int e) {
    const Whitening& whitening = fit_.whitening(l, e);
    Row row;
    Scaled gain[kMaxUnknowns];
    bool usable = level.periodic() && whitened_row(list_, level, whitening, e, -1, row);
    if (usable) fit_.factor().apply_covariance(row.column, gain);
    for (int b = 0; b < level.batch_count(); ++b) {
      if (!level.periodic()) {
        usable = whitened_row(list_, level, whitening, e, b, row);
        if (usable) fit_.factor().apply_covariance(row.column, gain);
      }
      if (!usable) continue;
      const Scaled change = whitened_change(level, whitening, table_.level[l].batch[b], b, e);
      for (int k = 0; k < list_.unknown_count; ++k) shift_[k] = shift_[k] + gain[k] * change;
    }
  }
  Scaled change(const LevelObservables& level, const Batch& batch, int b, int e) const {
    const int dof = list_.equation[e].dof;
    return power_[e] * counted_time(table_, batch, dof) * level.inverse_scale(b, dof);
  }
  Scaled whitened_change(const LevelObservables& level, const Whitening& whitening, const Batch& batch, int b,
                         int e) const {
    Scaled sum = change(level, batch, b, e);
    for (int j = 0; j < whitening.count; ++j)
      if (whitening.observable[j] >= kMaxControls)
        sum = sum - whitening.coefficient[j] * change(level, batch, b, whitening.observable[j] - kMaxControls);
    return sum / whitening.deviation;
  }

  const EquationList& list_;
  const BatchTable& table_;
  WeightedFit& fit_;
  Scaled power_[kMaxEquations], shift_[kMaxUnknowns];
};

}  // namespace

void add_noise_doubt(const CoreConfiguration& configuration, const EquationList& list, const BatchTable& table,
                     WeightedFit& fit, Estimates& estimates) {
  if (!any_doubt(configuration)) return;
  Doubt doubt(configuration, list, table, fit, estimates);
  for (int l = 0; l < table.level_count; ++l) doubt.add_level(l);
  for (int k = 0; k < list.unknown_count; ++k) {
    // The doubt is a bound: half of it is a deviation.
    widen(estimates.parameters[k], scale_by_power_of_two(doubt.shift(k), -1));
  }
}

}  // namespace firmware
