#include "firmware/warrant/motion/block_motion.hpp"
#include "firmware/warrant/probes/candidates.hpp"
#include "firmware/warrant/probes/model_terms.hpp"

namespace firmware {
namespace {

constexpr CoreTerm kMass = row_of(EffectKind::kMassError).core;

bool has(const CoreConfiguration& configuration, int node, Quantity quantity) {
  return node == kGroundNode || configuration.signals[node][static_cast<int>(quantity)].available;
}

class Planner {
 public:
  Planner(const CoreConfiguration& configuration, int most_values, ProbePlan& plan)
      : c_(configuration), model_(configuration), most_values_(most_values), plan_(plan) {}

  void places() {
    for (int l = 0; l < c_.link_count; ++l) add_place(PlaceKind::kLink, l, c_.links[l].node_a, c_.links[l].node_b);
    for (int i = 0; i < c_.dof_count; ++i) add_place(PlaceKind::kDof, 0, i, kGroundNode);
    for (int l = 0; l < c_.link_count; ++l) add_base_end(l);
    for (int i = 0; i < c_.dof_count; ++i) add_channels(PlaceKind::kVelocityChannels, Slope::kOfDisplacement, i);
    for (int i = 0; i < c_.dof_count; ++i) add_channels(PlaceKind::kAccelerationChannels, Slope::kOfVelocity, i);
    for (int i = 0; i < c_.dof_count; ++i) add_missing(i, kGroundNode);
    for (int i = 0; i < c_.dof_count; ++i)
      for (int j = i + 1; j < c_.dof_count; ++j)
        if (model_.share_a_neighbour(i, j)) add_missing(i, j);
  }

  void base_probes() {
    for (int t = 0; t < c_.term_count; ++t) {
      const Term& term = c_.terms[t];
      if (term.unknown < 0) continue;
      const PlaceKind kind = term.kind == TermKind::kMass ? PlaceKind::kDof : PlaceKind::kLink;
      const int place = find_place(kind, term.place);
      if (place >= 0) add(place, form_of(term.kind), Cause::kUnknown, kNoQuantity, term.unknown);
    }
    plan_.base_count = plan_.probe_count;
  }

  void candidates() {
    for (const Candidate& candidate : kOnLink)
      for (int p = 0; p < plan_.place_count; ++p)
        if (plan_.place[p].kind == PlaceKind::kLink && !model_.estimated(candidate.core, plan_.place[p].link) &&
            !(candidate.form == Form::kElongation && model_.sets_the_scale(TermKind::kStiffness, plan_.place[p].link)))
          add(p, candidate.form, candidate.cause, kNoQuantity, -1);
    for (int p = 0; p < plan_.place_count; ++p)
      for (const Elsewhere& candidate : kElsewhere) {
        const Place& place = plan_.place[p];
        if (candidate.kind != place.kind || !shows(candidate.form, place)) continue;
        const bool of_base = kHasBase && place.kind == PlaceKind::kBaseEnd;
        add(p, candidate.form, candidate.cause, of_base ? measured_quantity(kBaseNode) : candidate.quantity, -1);
      }
    plan_.summed_count = plan_.probe_count;
  }

  // A damper that changes with time, steadily or settling, needs no sums of its own.
  void drifting() {
    constexpr Drift kDrifts[] = {Drift::kSteady, Drift::kSettles};
    for (int j = 0; j < plan_.summed_count; ++j) {
      const Probe rate = plan_.probe[j];
      const Place& place = plan_.place[rate.place];
      if (rate.form != Form::kRate || place.kind != PlaceKind::kLink) continue;
      if (model_.has_term(TermKind::kDriftingViscous, place.link)) continue;
      for (const Drift drift : kDrifts) {
        if (drift == Drift::kSettles && (model_.integrated(place.node_a) || model_.integrated(place.node_b))) continue;
        if (plan_.probe_count == kMaxProbes) return;
        Probe& probe = plan_.probe[plan_.probe_count++];
        probe = rate;
        probe.drift = drift;
        probe.unknown = -1;
        probe.cause = cause_of(EffectKind::kDriftingViscous);
      }
    }
  }

 private:
  // Could the force be seen there?
  bool shows(Form form, const Place& place) const {
    if (place.kind != PlaceKind::kDof) return true;
    // An acceleration that is made from velocities here has no channel.
    const bool moves = form == Form::kAcceleration || form == Form::kJerk;
    const Quantity quantity = moves ? Quantity::kAcceleration : Quantity::kForce;
    if (!c_.signals[place.node_a][static_cast<int>(quantity)].available) return false;
    if (form == Form::kAcceleration)
      return !model_.estimated(kMass, place.node_a) && !model_.sets_the_scale(TermKind::kMass, place.node_a);
    // Where nothing weighs, a load cell reads what the links take: no part of that is without effect.
    if (form == Form::kForceWithinGap) return model_.weighs(place.dof[0]);
    return form != Form::kForce || model_.known_term_in(place.dof[0]);
  }
  void add_channels(PlaceKind kind, Slope slope, int dof) {
    if (plan_.place_count < kMaxPlaces && measures_slope(c_, slope, dof)) add_place(kind, 0, dof, kGroundNode);
  }
  void add_missing(int a, int b) {
    if (plan_.place_count < kMaxPlaces && !model_.joined(a, b)) add_place(PlaceKind::kNoLink, 0, a, b);
  }

  // A base that is read tau late leaves -k tau v of the base in the other end's equation.
  void add_base_end(int l) {
    const LinkConfiguration& link = c_.links[l];
    if (!kHasBase || plan_.place_count == kMaxPlaces) return;
    if (link.node_a == kBaseNode) add_place(PlaceKind::kBaseEnd, l, kGroundNode, link.node_b);
    if (link.node_b == kBaseNode) add_place(PlaceKind::kBaseEnd, l, kGroundNode, link.node_a);
  }
  uint8_t measured_quantity(int node) const {
    const auto present = [&](Quantity q) { return c_.channels[node][static_cast<int>(q)].present; };
    if (present(Quantity::kDisplacement)) return static_cast<uint8_t>(Quantity::kDisplacement);
    if (present(Quantity::kVelocity)) return static_cast<uint8_t>(Quantity::kVelocity);
    return static_cast<uint8_t>(Quantity::kAcceleration);
  }

  // a, b: the ends that have equations.
  void add_place(PlaceKind kind, int link, int a, int b) {
    Place& place = plan_.place[plan_.place_count];
    place = Place{};
    place.kind = kind;
    place.link = static_cast<uint8_t>(link);
    const bool base = kind == PlaceKind::kBaseEnd;
    place.node_a = static_cast<uint8_t>(base ? kBaseNode : a);
    place.node_b = static_cast<uint8_t>(base ? kGroundNode : b);
    const int ends[2] = {a, b};
    for (int e = 0; e < 2; ++e) {
      if (ends[e] >= c_.dof_count) continue;
      place.dof[place.equations] = static_cast<uint8_t>(ends[e]);
      place.sign[place.equations++] = e == 0 ? 1 : -1;
    }
    if (place.equations > 0 && add_columns(place)) ++plan_.place_count;
  }

  bool add_columns(Place& place) const {
    if (compares_channels(place.kind)) return true;
    for (int t = 0; t < c_.term_count; ++t) {
      const Term& term = c_.terms[t];
      if (term.unknown < 0) continue;
      int8_t sign[kPlaceEquations] = {};
      for (int e = 0; e < place.equations; ++e) sign[e] = model_.sign_in(term, place.dof[e]);
      if (sign[0] == 0 && sign[1] == 0) continue;
      if (place.columns == kMaxPlaceColumns) return false;
      place.unknown[place.columns] = static_cast<uint8_t>(term.unknown);
      for (int e = 0; e < place.equations; ++e) place.column_sign[place.columns][e] = sign[e];
      ++place.columns;
    }
    return true;
  }

  int find_place(PlaceKind kind, int number) const {
    for (int p = 0; p < plan_.place_count; ++p) {
      const Place& place = plan_.place[p];
      if (place.kind == kind && (kind == PlaceKind::kDof ? place.node_a : place.link) == number) return p;
    }
    return -1;
  }

  void add(int place, Form form, Cause cause, uint8_t quantity, int unknown) {
    const Place& where = plan_.place[place];
    const bool on_dof = moves_by_acceleration(where.kind);
    if (!on_dof) {
      if (!has(c_, where.node_a, Quantity::kVelocity) || !has(c_, where.node_b, Quantity::kVelocity)) return;
      const bool far = form == Form::kSignElongation || form == Form::kElongationSquareRate || !needs_rate(form);
      if (far && (!has(c_, where.node_a, Quantity::kDisplacement) || !has(c_, where.node_b, Quantity::kDisplacement)))
        return;
    }
    const int values = where.equations + where.columns + 1 + plan_.slopes;
    if (plan_.probe_count == kMaxProbes || plan_.value_count + values > most_values_) return;
    Probe& probe = plan_.probe[plan_.probe_count++];
    probe = Probe{};
    probe.form = form;
    probe.place = static_cast<uint8_t>(place);
    probe.unknown = static_cast<int8_t>(unknown);
    probe.cause = cause;
    probe.quantity = quantity;
    probe.first_value = static_cast<uint16_t>(plan_.value_count);
    plan_.value_count += values;
  }

  const CoreConfiguration& c_;
  const ModelTerms model_;
  int most_values_;
  ProbePlan& plan_;
};

}  // namespace

const Place& ProbePlan::place_of(int number) const { return place[probe[number].place]; }

void make_probe_plan(const CoreConfiguration& configuration, int most_values, ProbePlan& plan) {
  plan.place_count = plan.probe_count = plan.base_count = plan.summed_count = plan.value_count = 0;
  plan.slopes = configuration.shares_probe_noise ? 2 : 0;
  Planner planner(configuration, most_values, plan);
  planner.places();
  planner.base_probes();
  planner.candidates();
  planner.drifting();
}

}  // namespace firmware
