#include "firmware/identification/conditions/advice.hpp"

#include "firmware/identification/conditions/natural_frequencies.hpp"

namespace firmware {
namespace {

int find_status(const Estimates& estimates, EstimateStatus status) {
  for (int k = 0; k < estimates.unknown_count; ++k)
    if (estimates.parameters[k].status == status) return k;
  return -1;
}

// Mean frequency of a level's motion, sqrt(integral a^2 / integral v^2) / 2 pi; 0 where no acceleration is measured.
Scaled motion_frequency_Hz(const Level& level, int dofs) {
  Scaled motion, acceleration;
  for (int b = 0; b < level.batch_count; ++b)
    for (int i = 0; i < dofs; ++i) {
      motion += unpack(level.batch[b].dof[i].velocity_square);
      acceleration += unpack(level.batch[b].dof[i].acceleration_square);
    }
  return motion.is_zero() ? motion : sqrt(acceleration / motion) / Scaled::ratio(710, 113);
}

Scaled cycle_frequency_Hz(const CoreConfiguration& configuration) {
  const WindowConfiguration& window = configuration.window;
  if (window.cycle_samples_numerator == 0) return {};
  return Scaled::ratio(window.cycle_samples_denominator, window.cycle_samples_numerator) /
         configuration.sample_period_s;
}

// How far two frequencies are apart, as the ratio of the larger to the smaller.
Scaled distance(const Scaled& a, const Scaled& b) { return a > b ? a / b : b / a; }

// The natural frequency nearest to those excited but at least a quarter away from each: another mode shape moves the
// links in other proportions, and a resonance moves them strongly. Without one: half the lowest excited frequency.
Scaled second_frequency_Hz(const BatchTable& table, const CoreConfiguration& configuration,
                           const Estimates& estimates) {
  Scaled excited[kMaxLevels], natural[kMaxDofs], best, best_distance;
  Scaled lowest;
  for (int l = 0; l < table.level_count; ++l) {
    excited[l] = motion_frequency_Hz(table.level[l], configuration.dof_count);
    if (excited[l].is_zero()) excited[l] = cycle_frequency_Hz(configuration);
    if (lowest.is_zero() || excited[l] < lowest) lowest = excited[l];
  }
  best = scale_by_power_of_two(lowest, -1);
  if (lowest.is_zero() || !natural_frequencies_Hz(configuration, estimates, natural)) return best;
  for (int i = 0; i < configuration.dof_count; ++i) {
    if (natural[i].is_zero()) continue;
    Scaled nearest = distance(natural[i], excited[0]);
    for (int l = 1; l < table.level_count; ++l) {
      const Scaled to_level = distance(natural[i], excited[l]);
      if (to_level < nearest) nearest = to_level;
    }
    if (nearest < Scaled::ratio(5, 4) || (!best_distance.is_zero() && nearest > best_distance)) continue;
    best_distance = nearest;
    best = natural[i];
  }
  return best;
}

int worst_skew(const Estimates& estimates, int dofs) {
  int worst = 0;
  Scaled largest;
  for (int i = 0; i < dofs; ++i) {
    const SkewEstimate* const skews[] = {&estimates.displacement_skew[i], &estimates.acceleration_skew[i]};
    for (const SkewEstimate* skew : skews)
      if (skew->significant && exceeds(skew->late_s, largest)) {
        largest = skew->late_s;
        worst = i;
      }
  }
  return worst;
}

int widest_interval(const Estimates& estimates) {
  for (int k = 0; k < estimates.unknown_count; ++k)
    if (exceeds(scale_by_power_of_two(estimates.parameters[k].std, 2), estimates.parameters[k].value)) return k;
  return -1;
}

void set(Estimates& estimates, Advice advice, int index) {
  estimates.advice = advice;
  estimates.advice_index = index;
}

}  // namespace

void give_advice(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                 Estimates& estimates) {
  const bool periodic = table.level[0].periodic;
  if (find_status(estimates, EstimateStatus::kSaturated) >= 0) return set(estimates, Advice::kLowerLevel, -1);
  const int still = find_status(estimates, EstimateStatus::kNoExcitation);
  if (still >= 0) return set(estimates, Advice::kRaiseLevel, still);
  const int unresolved = find_status(estimates, EstimateStatus::kIllConditioned);
  if (unresolved >= 0 && periodic && table.level_count > 1) {
    estimates.advice_frequency_Hz = second_frequency_Hz(table, configuration, estimates);
    return set(estimates, Advice::kAddFrequency, unresolved);
  }
  if (unresolved >= 0 && (periodic || table.level[0].batch_count >= 2 * list.unknown_count))
    return set(estimates, Advice::kAddLevel, unresolved);
  if (unresolved >= 0) return set(estimates, Advice::kLongerRecord, unresolved);
  if (find_status(estimates, EstimateStatus::kSkewed) >= 0)
    return set(estimates, Advice::kCompensateSkew, worst_skew(estimates, list.dof_count));
  const int wide = widest_interval(estimates);
  if (wide >= 0) set(estimates, Advice::kRaiseLevel, wide);
}

}  // namespace firmware
