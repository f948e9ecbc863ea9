// From the sums of a batch to its energies: once a batch, in pieces.
#include "firmware/energy/energy_sums.hpp"
#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {
namespace {

constexpr int kPlain = static_cast<int>(Weight::kPlain);
constexpr int kInstrument = static_cast<int>(Weight::kInstrument);
constexpr Scaled kNothing;

}  // namespace

// 24 times the sum and its ends fit one word where the sum is below 2^57 (the ends are): the usual case. Both ways are
// exact up to 62 bits and round alike.
void EnergySums::read_sums(const Frame& frame, int boundary) {
  constexpr int64_t kFits = int64_t{1} << 57;
  for (int p = 0; p < sums_.count(); ++p) {
    const ProductSums::Sum closed = sums_.turn(p, frame, boundary);
    if (closed.sum < kFits && closed.sum > -kFits) {
      integral_[p].mantissa = 24 * closed.sum + closed.ends_times_24;  // not yet in its normal form
      integral_[p].exponent = 0;
    } else {
      integral_[p] = Scaled::from_int(closed.sum) * Scaled::from_int(24) + Scaled::from_int(closed.ends_times_24);
    }
  }
}

[[gnu::noinline]] const Scaled& EnergySums::integral(int product) const {
  return product == kNoProduct ? kNothing : integral_[product];
}

// The sign of a noisy rate is wrong near a crossing, which takes (noise variance) / (slope) from the integral. The smoothed
// rate (link_motion.hpp) has 67/200 of the white noise variance of the rate itself, so the loss is extrapolated to no noise:
// (C_smooth - g C) / (1 - g), g = 67/200.
Scaled EnergySums::friction_energy(const Incidence& incidence, int weight) const {
  const bool clear = plan_.dof[incidence.dof].clear_signs_only;
  if (clear && (weight != kPlain || configuration_->filters_sign())) return integral(incidence.product_a[weight]);
  const int column = weight_column(plan_, incidence.dof, weight);
  const int link = configuration_->terms[incidence.term].place;
  const Scaled crossing =
      configuration_->sample_period_s * plan_.column_unit[column] *
      Scaled::from_int(crossing_[&incidence - plan_.incidence][weight].raw, -Crossing::kFractionBits);
  Scaled own = integral(incidence.product_a[weight]);
  own += crossing;
  if (weight != kInstrument) return own;
  Scaled smooth = integral(incidence.product_smooth);
  smooth += crossing;
  if (!use_[link].smooth_is_white) return smooth;
  return (smooth * 200 - own * 67) / 133;
}

// Energy per unit mass from the end points.
Scaled EnergySums::kinetic_energy(int dof, int weight) const {
  const DofProducts& products = plan_.dof[dof];
  const int velocity = signal_column(dof, Quantity::kVelocity),
            displacement = signal_column(dof, Quantity::kDisplacement);
  const int64_t v0 = closed_start_.velocity[dof], v1 = closed_end_.velocity[dof];
  if (!is_displacement(weight)) {
    const Scaled& unit = plan_.column_unit[velocity];
    return unit * unit * Scaled::from_int(v1 * v1 - v0 * v0, -1);
  }
  const int64_t change = closed_end_.displacement[dof] * v1 - closed_start_.displacement[dof] * v0;
  return plan_.column_unit[displacement] * plan_.column_unit[velocity] * Scaled::from_int(change) -
         integral(products.velocity_instrument);
}

Scaled EnergySums::energy(const Incidence& incidence, int weight) const {
  const Term& term = configuration_->terms[incidence.term];
  Scaled result;
  if (is_sign_term(term.kind)) {
    result = friction_energy(incidence, weight);
  } else if (term.kind == TermKind::kMass && !plan_.dof[incidence.dof].has_acceleration) {
    result = kinetic_energy(incidence.dof, weight);
  } else {
    result = integral(incidence.product_a[weight]);
    result -= term.kind == TermKind::kMass ? shared_noise(incidence.dof, weight, Quantity::kAcceleration)
                                           : integral(incidence.product_b[weight]);
  }
  if (incidence.sign < 0) result = -result;
  if (!kDerivesSignals || !any_shared_noise_) return result;
  if (term.kind == TermKind::kViscous) result -= shared_noise(incidence.dof, weight, Quantity::kVelocity);
  if (term.kind == TermKind::kStiffness) result -= shared_noise(incidence.dof, weight, Quantity::kDisplacement);
  return result;
}

// Over the samples that the equation counts.
Scaled EnergySums::shared_noise(int dof, int weight, Quantity quantity) const {
  if (!kDerivesSignals || !any_shared_noise_) return {};
  const Scaled& product = configuration_->shared_noise[dof][weight][static_cast<int>(quantity)];
  if (product.is_zero()) return product;
  const bool all = !kDerivesSignals || weight == kPlain || !plan_.dof[dof].clear_signs_only;
  return product * configuration_->sample_period_s * Scaled::from_int(all ? closed_samples_ : closed_counted_[dof]);
}

void EnergySums::close_weight(int i, int q, Batch& batch) {
  const DofProducts& products = plan_.dof[i];
  BatchDof& dof = batch.dof[i];
  Scaled rhs = integral(products.force[q]);
  for (int n = plan_.first_incidence[i]; n < plan_.first_incidence[i + 1]; ++n) {
    const Incidence& incidence = plan_.incidence[n];
    const Scaled value = energy(incidence, q);
    if (incidence.column_slot >= 0) {
      batch.column[q][incidence.column_slot] = pack(value);
    } else {
      rhs -= configuration_->terms[incidence.term].value * value;
    }
  }
  dof.rhs[q] = pack(rhs);
  const Scaled& unit_v = plan_.column_unit[signal_column(i, Quantity::kVelocity)];
  const Scaled& unit_x = plan_.column_unit[signal_column(i, Quantity::kDisplacement)];
  const int64_t v0 = closed_start_.velocity[i], v1 = closed_end_.velocity[i];
  const int64_t x0 = closed_start_.displacement[i], x1 = closed_end_.displacement[i];
  if (q == kPlain) {
    kinetic_end_ = times(unit_v * unit_v, v1 * v1 - v0 * v0);
    elastic_end_ = times(unit_x * unit_x, x1 * x1 - x0 * x0);
    kinetic_end_ = scale_by_power_of_two(kinetic_end_, -1);
    elastic_end_ = scale_by_power_of_two(elastic_end_, -1);
    dof.kinetic_end = pack(kinetic_end_);
    dof.elastic_end = pack(elastic_end_);
  }
  if (!is_displacement(q)) {
    const auto less = [&](int product, const Scaled& end) {
      Scaled difference = integral(product);
      difference -= end;
      return pack(difference);
    };
    if (products.has_acceleration) dof.kinetic_discrepancy[q] = less(products.acceleration[q], kinetic_end_);
    if (products.has_displacement) dof.elastic_discrepancy[q] = less(products.displacement[q], elastic_end_);
    return;
  }
  dof.displacement_square() = pack(integral(products.displacement[q]));
  if (products.has_displacement && products.has_acceleration)
    dof.kinetic_discrepancy[q] = pack(integral(products.acceleration[q]) + integral(products.velocity_instrument) -
                                      unit_x * unit_v * Scaled::from_int(x1 * v1 - x0 * v0));
}

void EnergySums::close_dof(int i, Batch& batch) const {
  const DofProducts& products = plan_.dof[i];
  BatchDof& dof = batch.dof[i];
  dof.velocity_square = pack(integral(products.velocity_square));
  dof.velocity_instrument = pack(integral(products.velocity_instrument));
  dof.weight_square = pack(integral(products.weight_square));
  dof.acceleration_square = pack(integral(products.acceleration_square));
}

void EnergySums::begin_close(const Frame& frame, int boundary) {
  read_sums(frame, boundary);
  closed_start_ = start_;
  closed_end_ = start_ = end_point(frame, boundary);
  closed_samples_ = samples_;
  for (int i = 0; kDerivesSignals && i < configuration_->dof_count; ++i) closed_counted_[i] = counted_[i];
  converted_ = closing_dof_ = closing_weight_ = 0;
  begin_counts();
}

void EnergySums::convert(int product) {
  Scaled& sum = integral_[product];
  sum = sum.exponent == 0 ? times(integral_unit_[product], sum.mantissa) : integral_unit_[product] * sum;
}

bool EnergySums::go_on_closing(Batch& batch) {
  report_work(1000);  // a solve may find a batch that is being closed
  if (converted_ < sums_.count()) {
    for (int n = 0; n < kProductsAPiece && converted_ < sums_.count(); ++n, ++converted_) convert(converted_);
    return false;
  }
  if (closing_dof_ < configuration_->dof_count) {
    close_weight(closing_dof_, closing_weight_, batch);
    if (++closing_weight_ < weights_) return false;
    close_dof(closing_dof_++, batch);
    closing_weight_ = 0;
    if (closing_dof_ < configuration_->dof_count) return false;
  }
  batch.samples = closed_samples_;
  if (any_crossings_) clear_crossings();
  return true;
}

}  // namespace firmware
