#include "firmware/identification/conditions/skew.hpp"

#include "firmware/fixed_point/work_meter.hpp"
#include "firmware/identification/intervals/student_quantile.hpp"

namespace firmware {
namespace {

// Delays count from 1/200 of a sample period on; where friction imitates one, from 1/16 on at the most.
constexpr int kLeastShareOfPeriod = 200, kMostShareOfPeriod = 16;

struct Regression {
  Scaled weight, weighted;  // sums over levels of 1 / variance and of tau / variance
  Scaled freedom;           // sum over levels of (sum of energy)^2 / sum of energy^2 - 1
};

struct Sample {
  Scaled discrepancy, ends, energy;
};

Sample read(const BatchDof& dof, int weight, bool acceleration) {
  if (acceleration)
    return {unpack(dof.kinetic_discrepancy[weight]), unpack(dof.kinetic_end), unpack(dof.acceleration_square)};
  return {-unpack(dof.elastic_discrepancy[weight]), -unpack(dof.elastic_end), unpack(dof.velocity_square)};
}

// Sum of squares of discrepancy - tau * energy over the batches, with or without the end points, about its mean.
Scaled scatter(const Level& level, int dof, int weight, bool acceleration, const Scaled& tau, bool ends) {
  Scaled sum, squares;
  for (int b = 0; b < level.batch_count; ++b) {
    const Sample sample = read(level.batch[b].dof[dof], weight, acceleration);
    const Scaled rest = sample.discrepancy + (ends ? sample.ends : Scaled{}) - tau * sample.energy;
    sum += rest;
    multiply_add(squares, rest, rest);
  }
  return squares - sum * sum / level.batch_count;
}

void add_level(const Level& level, int dof, int weight, bool acceleration, Regression& regression) {
  Scaled discrepancy, energy, energy_square;
  for (int b = 0; b < level.batch_count; ++b) {
    const Sample sample = read(level.batch[b].dof[dof], weight, acceleration);
    discrepancy += sample.discrepancy;
    energy += sample.energy;
    multiply_add(energy_square, sample.energy, sample.energy);
  }
  if (level.batch_count < 3 || discrepancy.is_zero() || !energy.is_positive()) return;
  const Scaled tau = discrepancy / energy;
  const int n = level.batch_count;
  Scaled squares = scatter(level, dof, weight, acceleration, tau, false);
  if (level.periodic) {  // in the sum the ends of neighbouring batches cancel, all but two
    const Scaled without = scatter(level, dof, weight, acceleration, tau, true);
    if (without < squares) squares = without + (squares - without) / n;
  }
  // Where few batches carry the motion, the fitted tau takes most of their scatter with it.
  const Scaled count = energy * energy / energy_square, spare = count - kScaledOne;
  if (spare <= Scaled::ratio(1, 4)) return;
  regression.freedom += spare;
  const Scaled variance = squares * count / spare / (energy * energy);
  const Scaled rounding = scale_by_power_of_two(tau * tau, -40);
  const Scaled weight_of_level = kScaledOne / (variance > rounding ? variance : rounding);
  regression.weight += weight_of_level;
  multiply_add(regression.weighted, weight_of_level, tau);
}

// Of the DOF, over all batches.
Scaled sum_of(const BatchTable& table, int dof, PackedScaled BatchDof::*what) {
  Scaled sum;
  for (int l = 0; l < table.level_count; ++l)
    for (int b = 0; b < table.level[l].batch_count; ++b) sum += unpack(table.level[l].batch[b].dof[dof].*what);
  return sum;
}

const Scaled& coefficient(const Term& term, const Estimates& estimates) {
  return term.unknown < 0 ? term.value : estimates.parameters[term.unknown].value;
}

bool is_at(const LinkConfiguration& link, int dof) { return link.node_a == dof || link.node_b == dof; }

// Sum of the coefficients of a kind in the DOF's equation, or of their sizes.
Scaled sum_at(const CoreConfiguration& configuration, int dof, TermKind kind, bool sizes, const Estimates& estimates) {
  Scaled sum;
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    const bool there = term.kind == TermKind::kMass ? term.place == dof : is_at(configuration.links[term.place], dof);
    if (term.kind != kind || !there) continue;
    const Scaled& one = coefficient(term, estimates);
    sum += sizes ? abs(one) : one;
  }
  return sum;
}

Scaled duration_of(const BatchTable& table) {
  int64_t samples = 0;
  for (int l = 0; l < table.level_count; ++l)
    for (int b = 0; b < table.level[l].batch_count; ++b) samples += table.level[l].batch[b].samples;
  return Scaled::from_int(samples) * table.sample_period_s;
}

// Friction turns inside a sample interval, and the acceleration jumps by 2 F / m there. The trapezoid puts the jump in the interval's
// middle: v F h / m of kinetic energy, at the most, where it turns at the same place of every cycle. Two such jumps a cycle of frequency w,
// over the integral of a^2, are a delay of h F v / (pi m v a), v and a rms, a = w v.
Scaled least_acceleration_skew_s(const CoreConfiguration& configuration, const BatchTable& table, int dof,
                                 const Estimates& estimates) {
  const Scaled friction = sum_at(configuration, dof, TermKind::kCoulomb, true, estimates);
  const Scaled least = table.sample_period_s / kLeastShareOfPeriod, most = table.sample_period_s / kMostShareOfPeriod;
  if (friction.is_zero()) return least;
  const Scaled mass = sum_at(configuration, dof, TermKind::kMass, true, estimates);
  const Scaled inertia = mass * sqrt(sum_of(table, dof, &BatchDof::acceleration_square) / duration_of(table));
  const Scaled jumps = table.sample_period_s * friction / 3;  // pi
  if (!(jumps < most * inertia)) return most;
  return jumps > least * inertia ? jumps / inertia : least;
}

SkewEstimate measure(const BatchTable& table, int dof, int weight, bool acceleration) {
  Regression regression;
  for (int l = 0; l < table.level_count; ++l) add_level(table.level[l], dof, weight, acceleration, regression);
  SkewEstimate result;
  if (regression.weight.is_zero()) return result;
  result.measured = true;
  result.late_s = regression.weighted / regression.weight;
  result.std_s = kScaledOne / sqrt(regression.weight);
  // Over twice the 95 % interval: four deviations, and more where few batches tell them.
  result.significant =
      exceeds(result.late_s, Scaled::from_int(4) * result.std_s) &&
      exceeds(result.late_s, table.sample_period_s / kLeastShareOfPeriod) &&
      exceeds(result.late_s, scale_by_power_of_two(result.std_s, 1) * student_quantile_95(regression.freedom));
  return result;
}

// A channel that reads g times the other's integral leaves (g - 1) of the change of energy, a late one tau times the motion's: which of the
// two does the batches' discrepancies better? Where the first leaves a quarter of what the second does the channel is not late.
bool reads_a_gain(const BatchTable& table, int dof, int weight, bool acceleration) {
  Scaled by_ends, ends, by_energy, energy, all;
  for (int l = 0; l < table.level_count; ++l)
    for (int b = 0; b < table.level[l].batch_count; ++b) {
      const Sample s = read(table.level[l].batch[b].dof[dof], weight, acceleration);
      multiply_add(by_ends, s.discrepancy, s.ends), multiply_add(ends, s.ends, s.ends);
      multiply_add(by_energy, s.discrepancy, s.energy), multiply_add(energy, s.energy, s.energy);
      multiply_add(all, s.discrepancy, s.discrepancy);
    }
  if (ends.is_zero() || energy.is_zero()) return false;
  const Scaled left_by_gain = all - by_ends * by_ends / ends, left_by_delay = all - by_energy * by_energy / energy;
  return scale_by_power_of_two(left_by_gain, 2) < left_by_delay;
}

Scaled motion_of(const BatchTable& table, int dof) { return sum_of(table, dof, &BatchDof::velocity_square); }

// Viscous coefficient that the DOF's skews imitate.
Scaled imitated_damping(const CoreConfiguration& configuration, const BatchTable& table, int dof, const Skews& skews,
                        const Estimates& estimates) {
  const Scaled stiffness = sum_at(configuration, dof, TermKind::kStiffness, false, estimates);
  const Scaled mass = sum_at(configuration, dof, TermKind::kMass, false, estimates);
  const Scaled motion = motion_of(table, dof), acceleration = sum_of(table, dof, &BatchDof::acceleration_square);
  Scaled damping = abs(stiffness) * skews.displacement[dof];
  if (!motion.is_zero()) damping += abs(mass) * skews.acceleration[dof] * acceleration / motion;
  return damping;
}

// Work in the DOF's equation of springs whose other end's displacement is skewed, at the most.
Scaled work_of_neighbours(const CoreConfiguration& configuration, const BatchTable& table, int dof, const Skews& skews,
                          const Estimates& estimates) {
  Scaled work;
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    if (term.kind != TermKind::kStiffness) continue;
    const LinkConfiguration& link = configuration.links[term.place];
    if (!is_at(link, dof)) continue;
    const int other = link.node_a == dof ? link.node_b : link.node_a;
    if (other >= configuration.dof_count || skews.displacement[other].is_zero()) continue;
    const Scaled damping = abs(coefficient(term, estimates)) * skews.displacement[other];
    multiply_add(work, damping, sqrt(motion_of(table, dof) * motion_of(table, other)));
  }
  return work;
}

}  // namespace

void measure_skew(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                  Estimates& estimates) {
  for (int i = 0; i < list.dof_count; ++i) {
    const int weight = static_cast<int>(list.equation[i].weight);
    estimates.displacement_skew[i] = measure(table, i, weight, false);
    SkewEstimate& a = estimates.acceleration_skew[i];
    a = measure(table, i, weight, true);
    if (!configuration.fuses(i)) {
      SkewEstimate& x = estimates.displacement_skew[i];
      x.significant = x.significant && !reads_a_gain(table, i, weight, false);
      a.significant = a.significant && !reads_a_gain(table, i, weight, true);
    }
    a.significant = a.significant && exceeds(a.late_s, least_acceleration_skew_s(configuration, table, i, estimates));
  }
}

Scaled bend_of_skews(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                     int unknown, const Skews& skews, const Estimates& estimates) {
  Scaled most;
  for (int i = 0; i < list.dof_count; ++i) {
    Scaled energy;  // of the unknown's unit force
    for (int l = 0; l < table.level_count; ++l)
      for (int b = 0; b < table.level[l].batch_count; ++b) {
        const Batch& batch = table.level[l].batch[b];
        report_work(20 + 20 * (table.layout.first[i + 1] - table.layout.first[i]));
        for (int n = table.layout.first[i]; n < table.layout.first[i + 1]; ++n)
          if (table.layout.unknown[n] == unknown)
            energy += unpack(batch.column[static_cast<int>(list.equation[i].weight)][n]);
      }
    if (energy.is_zero()) continue;
    const Scaled work = imitated_damping(configuration, table, i, skews, estimates) * motion_of(table, i) +
                        work_of_neighbours(configuration, table, i, skews, estimates);
    keep_larger(most, work / abs(energy));
  }
  return most;
}

bool skew_matters(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                  int unknown, const Estimates& estimates) {
  Skews significant;
  bool any = false;
  for (int i = 0; i < list.dof_count; ++i) {
    const SkewEstimate &x = estimates.displacement_skew[i], &a = estimates.acceleration_skew[i];
    if (x.significant) significant.displacement[i] = abs(x.late_s);
    if (a.significant) significant.acceleration[i] = abs(a.late_s);
    any = any || x.significant || a.significant;
  }
  if (!any) return false;  // nothing imitates damping
  const ParameterEstimate& parameter = estimates.parameters[unknown];
  const Scaled shift = bend_of_skews(list, table, configuration, unknown, significant, estimates);
  return shift > scale_by_power_of_two(parameter.std, 1) && exceeds(shift, parameter.value / 50);
}

}  // namespace firmware
