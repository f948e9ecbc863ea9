#include "firmware/energy/equation_plan.hpp"

namespace firmware {
namespace {

int all_samples_column(int i, int weight) {
  if (is_displacement(weight)) return kDisplacementInstrumentColumn + i;
  return weight == static_cast<int>(Weight::kPlain) ? signal_column(i, Quantity::kVelocity) : kInstrumentColumn + i;
}

class Planner {
 public:
  Planner(const CoreConfiguration& configuration, int weights, EquationPlan& plan, ProductSums& sums)
      : configuration_(configuration), weights_(weights), plan_(plan), sums_(sums) {}

  void dof(int i) {
    DofProducts& products = plan_.dof[i];
    products.has_displacement = has(i, Quantity::kDisplacement);
    products.has_velocity = has(i, Quantity::kVelocity);
    products.has_acceleration = has(i, Quantity::kAcceleration);
    products.clear_signs_only = products.has_acceleration && weights_ > 1 && has_friction(i);
    for (int q = 0; q < weights_; ++q) {
      products.force[q] = weighted(i, q, i, Quantity::kForce);
      products.displacement[q] =
          is_displacement(q) ? weighted(i, q, i, Quantity::kDisplacement) : kinematic(i, q, Quantity::kDisplacement);
      products.acceleration[q] = kinematic(i, q, Quantity::kAcceleration);
    }
    products.velocity_square = weighted(i, 0, i, Quantity::kVelocity);
    if (weights_ > 1) {
      products.velocity_instrument = kinematic(i, 1, Quantity::kVelocity);
      products.weight_square = weighted(i, 1, i, Quantity::kVelocity);
    }
    const int acceleration = signal_column(i, Quantity::kAcceleration);
    if (products.has_acceleration && weights_ > 1) products.acceleration_square = sums_.add(acceleration, acceleration);
  }

  // All coefficients of DOF i's equation.
  void terms_of(int i) {
    int effects = 0;
    for (int t = 0; t < configuration_.term_count; ++t) {
      const Term& each = configuration_.terms[t];
      if (each.kind == TermKind::kMass) {
        if (each.place == i) term(t, i, 1, 0);
        continue;
      }
      // Effects beyond the columns are in no equation: such a core does not fit, and is given nothing to measure.
      if (is_effect_term(each.kind) && effects == kMaxEffectColumns) continue;
      const LinkConfiguration& link = configuration_.links[each.place];
      if (link.node_a == i) term(t, i, 1, effects);
      if (link.node_b == i) term(t, i, -1, effects);
      if (is_effect_term(each.kind)) ++effects;
    }
  }

 private:
  // The term's force on DOF i: column a (and minus column b), with its sign in the equation of motion.
  void term(int t, int i, int sign, int effect) {
    const Term& term = configuration_.terms[t];
    Incidence& incidence = plan_.incidence[plan_.incidence_count++];
    incidence = Incidence{};
    incidence.dof = static_cast<uint8_t>(i);
    incidence.term = static_cast<uint8_t>(t);
    incidence.sign = static_cast<int8_t>(sign);
    for (int q = 0; q < weights_; ++q) {
      if (term.kind == TermKind::kMass) {
        incidence.product_a[q] = weighted(i, q, i, Quantity::kAcceleration);
      } else if (is_sign_term(term.kind)) {
        const bool clear = (q > 0 || configuration_.filters_sign()) && plan_.dof[i].clear_signs_only;
        incidence.column_a = static_cast<uint16_t>((clear ? kClearSignColumn : kSignColumn) + term.place);
        incidence.product_a[q] = weighted_column(i, q, incidence.column_a);
      } else if (is_effect_term(term.kind)) {
        incidence.column_a = static_cast<uint16_t>(kEffectColumn + effect);
        incidence.product_a[q] = weighted_column(i, q, incidence.column_a);
      } else {
        const Quantity quantity = term.kind == TermKind::kStiffness ? Quantity::kDisplacement : Quantity::kVelocity;
        const LinkConfiguration& link = configuration_.links[term.place];
        if (link.node_a != kGroundNode) incidence.product_a[q] = weighted(i, q, link.node_a, quantity);
        if (link.node_b != kGroundNode) incidence.product_b[q] = weighted(i, q, link.node_b, quantity);
        incidence.column_a = static_cast<uint16_t>(signal_column(link.node_a % kMaxNodes, quantity));
        incidence.column_b = static_cast<uint16_t>(signal_column(link.node_b % kMaxNodes, quantity));
      }
    }
    if (is_sign_term(term.kind) && weights_ > 1 && !plan_.dof[i].clear_signs_only)
      incidence.product_smooth = weighted_column(i, 1, kSmoothSignColumn + term.place);
  }

  bool has(int node, Quantity quantity) const {
    return configuration_.signals[node][static_cast<int>(quantity)].available;
  }
  bool has_friction(int i) const {
    for (int t = 0; t < configuration_.term_count; ++t) {
      const Term& term = configuration_.terms[t];
      if (!is_sign_term(term.kind)) continue;
      const LinkConfiguration& link = configuration_.links[term.place];
      if (link.node_a == i || link.node_b == i) return true;
    }
    return false;
  }
  bool has_weight(int i, int weight) const {
    return has(i, is_displacement(weight) ? Quantity::kDisplacement : Quantity::kVelocity);
  }
  int16_t weighted_column(int i, int weight, int column) {
    return has_weight(i, weight) ? sums_.add(weight_column(plan_, i, weight), column) : kNoProduct;
  }
  // Of the identities that hold for any rig: all samples count.
  int16_t kinematic(int i, int weight, Quantity quantity) {
    if (!has_weight(i, weight) || !has(i, quantity)) return kNoProduct;
    return sums_.add(all_samples_column(i, weight), signal_column(i, quantity));
  }
  int16_t weighted(int i, int weight, int node, Quantity quantity) {
    return has(node, quantity) ? weighted_column(i, weight, signal_column(node, quantity)) : kNoProduct;
  }

  const CoreConfiguration& configuration_;
  int weights_;
  EquationPlan& plan_;
  ProductSums& sums_;
};

void set_column_units(const CoreConfiguration& configuration, EquationPlan& plan) {
  for (int node = 0; node < kMaxNodes; ++node) {
    for (int quantity = 0; quantity < kQuantities; ++quantity)
      plan.column_unit[node * kQuantities + quantity] = configuration.signals[node][quantity].unit_per_code;
    const Scaled& velocity = configuration.signals[node][static_cast<int>(Quantity::kVelocity)].unit_per_code;
    const Scaled& displacement = configuration.signals[node][static_cast<int>(Quantity::kDisplacement)].unit_per_code;
    if (node >= kMaxDofs) continue;
    plan.column_unit[kInstrumentColumn + node] = plan.column_unit[kClearInstrumentColumn + node] = velocity / 6;
    if (kWeights < 3) continue;
    plan.column_unit[kDisplacementInstrumentColumn + node] = plan.column_unit[kClearDisplacementColumn + node] =
        displacement / 6;
  }
  for (int link = 0; link < kMaxLinks; ++link)
    plan.column_unit[kSignColumn + link] = plan.column_unit[kSmoothSignColumn + link] =
        plan.column_unit[kClearSignColumn + link] = kScaledOne;
  if (!configuration.filters_sign()) return;
  for (int link = 0; link < kMaxLinks; ++link)
    plan.column_unit[kClearSignColumn + link] = power_of_two(-PassedSign::kFractionBits);
}

// Gives every unknown of DOF i a slot, in the order of the unknowns' first appearance.
void assign_slots(const CoreConfiguration& configuration, int weights, EquationPlan& plan, RowLayout& layout) {
  layout = RowLayout{};
  layout.dof_count = configuration.dof_count;
  layout.unknown_count = configuration.unknown_count;
  layout.weight_count = static_cast<uint8_t>(weights);
  int slots = 0;
  for (int i = 0; i < configuration.dof_count; ++i) {
    layout.first[i] = static_cast<uint8_t>(slots);
    for (int n = plan.first_incidence[i]; n < plan.first_incidence[i + 1]; ++n) {
      Incidence& incidence = plan.incidence[n];
      const int unknown = configuration.terms[incidence.term].unknown;
      if (unknown < 0 || slots == kMaxIncidences) continue;
      incidence.column_slot = static_cast<int16_t>(slots);
      layout.unknown[slots++] = static_cast<uint8_t>(unknown);
    }
  }
  for (int i = configuration.dof_count; i <= kMaxDofs; ++i) layout.first[i] = static_cast<uint8_t>(slots);
}

}  // namespace

int weight_column(const EquationPlan& plan, int i, int weight) {
  if (weight == static_cast<int>(Weight::kPlain) || !plan.dof[i].clear_signs_only) return all_samples_column(i, weight);
  return (is_displacement(weight) ? kClearDisplacementColumn : kClearInstrumentColumn) + i;
}

void make_equation_plan(const CoreConfiguration& configuration, int weights, EquationPlan& plan, ProductSums& sums,
                        RowLayout& layout) {
  sums.clear_plan();
  plan.incidence_count = 0;
  for (DofProducts& products : plan.dof) products = DofProducts{};
  Planner planner(configuration, weights, plan, sums);
  for (int i = 0; i < configuration.dof_count; ++i) planner.dof(i);
  for (int i = 0; i < configuration.dof_count; ++i) {
    plan.first_incidence[i] = static_cast<uint16_t>(plan.incidence_count);
    planner.terms_of(i);
  }
  for (int i = configuration.dof_count; i <= kMaxDofs; ++i)
    plan.first_incidence[i] = static_cast<uint16_t>(plan.incidence_count);
  sums.finish_plan();
  set_column_units(configuration, plan);
  assign_slots(configuration, weights, plan, layout);
}

}  // namespace firmware
