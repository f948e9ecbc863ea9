// See energy_watch.hpp.
#include "firmware/supervision/energy_watch.hpp"

namespace firmware {
namespace {

constexpr int kDeviations = 6;
constexpr int kDisplacementPerMille = 10, kVelocityPerMille = 30;
constexpr int kLeaningPerMille = 4;  // enough beside another DOF that is off balance
constexpr int kFloorPer10000 = 5;    // balance that sampling and integration leave in a good model
constexpr int kCausePercent = 3;     // how exactly the formulas of the causes hold
constexpr int kLargestMisfit = 9;    // chi-squared per level of a cause that fits

Scaled per_mille_of(Scaled value, int per_mille) { return value * Scaled::ratio(per_mille, 1000); }
Scaled square(Scaled value) { return value * value; }

uint16_t per_mille(Scaled part, Scaled whole) {
  if (whole.is_zero()) return 0;
  const int64_t value = to_fixed(abs(part) / whole * Scaled::from_int(1000), 0);
  return static_cast<uint16_t>(value > 1000 ? 1000 : value);
}

Scaled value_of(const Term& term, const Scaled* parameters) {
  return term.unknown >= 0 ? parameters[term.unknown] : term.value;
}

bool touches(const CoreConfiguration& configuration, const Term& term, int dof) {
  const LinkConfiguration& link = configuration.links[term.place];
  return link.node_a == dof || link.node_b == dof;
}

}  // namespace

bool EnergyWatch::judge(const CoreConfiguration& configuration, const BatchTable& table, const Estimates& estimates,
                        Diagnosis& diagnosis) {
  if (!believable(estimates)) return false;
  for (int k = 0; k < estimates.unknown_count; ++k) parameters_[k] = estimates.parameters[k].value;
  diagnosis = Diagnosis{};
  if (skewed(estimates, diagnosis)) return true;
  int worst = 0;
  load(configuration, table, Weight::kDisplacement);
  if (levels_ == 0) return false;
  const uint32_t sprung = dofs_off_balance(kDisplacementPerMille, worst, diagnosis.unexplained_permille);
  if (sprung != 0) name_displacement_finding(configuration, sprung | dofs_leaning(), worst, diagnosis);
  const bool named = diagnosis.cause != Cause::kNone && diagnosis.cause != Cause::kUnknown;
  if (!named) judge_damping(configuration, table, diagnosis);
  return true;
}

// Equations with the velocity weight: something takes up energy otherwise than the model says.
void EnergyWatch::judge_damping(const CoreConfiguration& configuration, const BatchTable& table, Diagnosis& diagnosis) {
  int worst = 0;
  uint16_t worst_per_mille = 0;
  load(configuration, table, Weight::kInstrument);
  if (dofs_off_balance(kVelocityPerMille, worst, worst_per_mille) == 0) return;
  diagnosis.cause = Cause::kUnknown;
  diagnosis.place_a = place_of_node(worst);
  diagnosis.place_b = Diagnosis{}.place_b;
  diagnosis.unexplained_permille = worst_per_mille;
}

bool EnergyWatch::believable(const Estimates& estimates) const {
  for (int k = 0; k < estimates.unknown_count; ++k) {
    const EstimateStatus status = estimates.parameters[k].status;
    const bool usable =
        status == EstimateStatus::kValid || status == EstimateStatus::kBiasSuspect || status == EstimateStatus::kSkewed;
    if (!usable) return false;
  }
  return true;
}

bool EnergyWatch::skewed(const Estimates& estimates, Diagnosis& diagnosis) const {
  for (int dof = 0; dof < kMaxDofs; ++dof) {
    const bool displacement = estimates.displacement_skew[dof].significant;
    if (!displacement && !estimates.acceleration_skew[dof].significant) continue;
    diagnosis.cause = Cause::kSensorDelay;
    diagnosis.place_a = place_of_node(dof);
    diagnosis.quantity = static_cast<uint8_t>(displacement ? Quantity::kDisplacement : Quantity::kAcceleration);
    return true;
  }
  return false;
}

void EnergyWatch::load(const CoreConfiguration& configuration, const BatchTable& table, Weight weight) {
  levels_ = 0;
  dofs_ = configuration.dof_count;
  for (int l = 0; l < table.level_count; ++l) {
    const Level& level = table.level[l];
    if (level.saturated || level.batch_count < kGroups) continue;
    for (int dof = 0; dof < dofs_; ++dof) {
      Balance& balance = balance_[levels_][dof];
      load_balance(table, level, dof, weight, balance);
      balance.energy = weight == Weight::kDisplacement ? displacement_energy(configuration, dof, balance)
                                                       : damping_energy(table, level, dof, weight);
      balance.uncertainty = sqrt(balance.uncertainty + square(balance.energy * Scaled::ratio(kFloorPer10000, 10000)));
    }
    ++levels_;
  }
}

// uncertainty is left as the variance of the residual: the sum over groups, from their scatter.
void EnergyWatch::load_balance(const BatchTable& table, const Level& level, int dof, Weight weight,
                               Balance& balance) const {
  const Equation equation{static_cast<uint8_t>(dof), weight};
  Scaled group[kGroups];
  Scaled acceleration_square;
  uint64_t samples = 0;
  balance = Balance{};
  for (int b = 0; b < level.batch_count; ++b) {
    const Batch& batch = level.batch[b];
    Scaled& sum = group[b * kGroups / level.batch_count];
    sum = sum + batch_residual(table.layout, batch, equation, parameters_);
    balance.motion = balance.motion + unpack(batch.dof[dof].velocity_square);
    acceleration_square = acceleration_square + unpack(batch.dof[dof].acceleration_square);
    samples += batch.samples;
  }
  for (const Scaled& sum : group) balance.residual = balance.residual + sum;
  const Scaled mean = balance.residual / Scaled::from_int(kGroups);
  for (const Scaled& sum : group) balance.uncertainty = balance.uncertainty + square(sum - mean);
  balance.uncertainty = balance.uncertainty * Scaled::ratio(kGroups, kGroups - 1);
  balance.duration_s = Scaled::from_int(static_cast<int64_t>(samples)) * table.sample_period_s;
  balance.present = !balance.motion.is_zero() && !acceleration_square.is_zero();
  if (balance.present) balance.rate_square = acceleration_square / balance.motion;
}

// Twice the kinetic and the elastic energy: m V + k V / w^2, with all springs at the DOF.
Scaled EnergyWatch::displacement_energy(const CoreConfiguration& configuration, int dof, const Balance& balance) const {
  if (!balance.present) return Scaled{};
  Scaled mass, stiffness;
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    if (term.kind == TermKind::kMass && term.place == dof) mass = mass + value_of(term, parameters_);
    if (term.kind == TermKind::kStiffness && touches(configuration, term, dof))
      stiffness = stiffness + value_of(term, parameters_);
  }
  return abs(mass) * balance.motion + abs(stiffness) * balance.motion / balance.rate_square;
}

// What the dampers at the DOF take up, each by itself.
Scaled EnergyWatch::damping_energy(const BatchTable& table, const Level& level, int dof, Weight weight) const {
  const RowLayout& layout = table.layout;
  Scaled energy;
  for (int place = layout.first[dof]; place < layout.first[dof + 1]; ++place) {
    Scaled sum;
    for (int b = 0; b < level.batch_count; ++b)
      sum = sum + unpack(level.batch[b].column[static_cast<int>(weight)][place]);
    energy = energy + abs(sum * parameters_[layout.unknown[place]]);
  }
  return energy;
}

bool EnergyWatch::off_balance(const Balance& balance, int limit_per_mille) const {
  const Scaled size = abs(balance.residual);
  return balance.present && size > balance.uncertainty * Scaled::from_int(kDeviations) &&
         size > per_mille_of(balance.energy, limit_per_mille);
}

// Bit i: DOF i is off balance in some level. worst: where by the largest part of its energy.
uint32_t EnergyWatch::dofs_off_balance(int limit_per_mille, int& worst, uint16_t& worst_per_mille) const {
  uint32_t found = 0;
  worst_per_mille = 0;
  for (int level = 0; level < levels_; ++level) {
    for (int dof = 0; dof < dofs_; ++dof) {
      const Balance& balance = balance_[level][dof];
      if (!off_balance(balance, limit_per_mille)) continue;
      found |= 1u << dof;
      const uint16_t part = per_mille(balance.residual, balance.energy);
      if (part <= worst_per_mille) continue;
      worst_per_mille = part;
      worst = dof;
    }
  }
  return found;
}

// Bit i: DOF i leans to the same side in every level: too little to be told by itself.
uint32_t EnergyWatch::dofs_leaning() const {
  uint32_t found = 0;
  for (int dof = 0; dof < dofs_; ++dof) {
    int up = 0, down = 0;
    for (int level = 0; level < levels_; ++level) {
      const Balance& balance = balance_[level][dof];
      if (!balance.present || abs(balance.residual) < per_mille_of(balance.energy, kLeaningPerMille)) continue;
      (balance.residual.is_negative() ? down : up) += 1;
    }
    if (up == levels_ || down == levels_) found |= 1u << dof;
  }
  return found;
}

EnergyWatch::Finding EnergyWatch::explain(int dof, bool may_be_mass) const {
  constexpr Cause kCandidates[] = {Cause::kMassError, Cause::kStiffnessError, Cause::kCubicStiffness, Cause::kNone};
  Finding finding{Cause::kUnknown, Scaled{}};
  int fitting = 0;
  for (Cause candidate : kCandidates) {
    if (candidate == Cause::kMassError && !may_be_mass) continue;
    Scaled whole, product, size;  // of the residuals, of both, of the candidate's column; weighted
    int levels = 0;
    for (int level = 0; level < levels_; ++level) {
      const Balance& balance = balance_[level][dof];
      if (!balance.present) continue;
      const Scaled elastic = balance.motion / balance.rate_square;
      const Scaled column = candidate == Cause::kMassError        ? balance.motion
                            : candidate == Cause::kStiffnessError ? elastic
                            : candidate == Cause::kCubicStiffness ? square(elastic) / balance.duration_s
                                                                  : balance.duration_s;
      const Scaled inexact = balance.residual * Scaled::ratio(kCausePercent, 100);
      const Scaled weight = Scaled::from_int(1) / (square(balance.uncertainty) + square(inexact));
      whole = whole + square(balance.residual) * weight;
      product = product + balance.residual * column * weight;
      size = size + square(column) * weight;
      ++levels;
    }
    const Scaled left = size.is_zero() ? whole : whole - square(product) / size;
    if (left > Scaled::from_int(kLargestMisfit * levels)) continue;
    finding = {fitting++ == 0 ? candidate : Cause::kAmbiguous, left / whole};
  }
  return finding;
}

void EnergyWatch::name_displacement_finding(const CoreConfiguration& configuration, uint32_t dofs, int worst,
                                            Diagnosis& diagnosis) const {
  diagnosis.cause = Cause::kUnknown;
  diagnosis.place_a = place_of_node(worst);
  const bool alone = dofs == 1u << worst;
  int link = -1;
  for (int l = 0; l < configuration.link_count; ++l) {
    const LinkConfiguration& ends = configuration.links[l];
    const uint32_t reach =
        (ends.node_a < kMaxDofs ? 1u << ends.node_a : 0) | (ends.node_b < kMaxDofs ? 1u << ends.node_b : 0);
    if (reach == dofs) link = l;
  }
  if (!alone && link < 0) return;
  const Finding finding = explain(worst, alone);
  diagnosis.cause = finding.cause;
  if (finding.cause == Cause::kNone) {  // as sensor noise would
    diagnosis.place_a = Diagnosis{}.place_a;
    diagnosis.unexplained_permille = 0;
    return;
  }
  if (finding.cause == Cause::kUnknown) return;
  if (finding.cause != Cause::kAmbiguous)
    diagnosis.gained_permille = per_mille(Scaled::from_int(1) - sqrt(finding.left_over), Scaled::from_int(1));
  if (finding.cause == Cause::kMassError || link < 0) return;
  diagnosis.place_a = place_of_node(configuration.links[link].node_a);
  diagnosis.place_b = place_of_node(configuration.links[link].node_b);
}

}  // namespace firmware
