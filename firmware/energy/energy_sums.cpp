#include "firmware/energy/energy_sums.hpp"

#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {
namespace {

constexpr int kPlain = static_cast<int>(Weight::kPlain);
constexpr int kInstrument = static_cast<int>(Weight::kInstrument);
constexpr int kDisplacement = static_cast<int>(Weight::kDisplacement);

// Mean differences between a rate and its neighbours beyond which the rate's sign is clear (links/clear_sign.hpp). Half of a
// derived velocity's noise and more is slower than that.
constexpr int kClearMeans = 4, kClearMeansDerived = 8;

void copy(Frame& frame, int to_column, int from_column, int from, int to) {
  for (int n = from; n < to; ++n) frame.raw[to_column][n] = frame.raw[from_column][n];
}

bool measured_velocity(const CoreConfiguration& configuration, int node) {
  return node == kGroundNode || !configuration.signals[node][static_cast<int>(Quantity::kVelocity)].derived;
}

// Of the rate whose sign friction has.
RateGains sign_gains(const CoreConfiguration& configuration, RateGains gains) {
  if (!configuration.filters_sign()) return gains;
  gains.column_a = static_cast<uint16_t>(kSignVelocityColumn + gains.column_a / kQuantities);
  gains.column_b = static_cast<uint16_t>(kSignVelocityColumn + gains.column_b / kQuantities);
  return gains;
}

}  // namespace

void EnergySums::configure(const CoreConfiguration& configuration, int weights) {
  configuration_ = &configuration;
  weights_ = weights;
  make_equation_plan(configuration, weights, plan_, sums_, layout_);
  effects_.configure(configuration, plan_.column_unit);
  const Scaled step = configuration.sample_period_s / Scaled::from_int(24);
  for (int p = 0; p < sums_.count(); ++p)
    integral_unit_[p] = step * plan_.column_unit[sums_.column_a(p)] * plan_.column_unit[sums_.column_b(p)];
  for (int l = 0; l < configuration.link_count; ++l) {
    const LinkConfiguration& link = configuration.links[l];
    gains_[l] = rate_gains(configuration, link);
    const bool white = measured_velocity(configuration, link.node_a) && measured_velocity(configuration, link.node_b);
    clear_sign_[l].configure(sign_gains(configuration, gains_[l]), white ? kClearMeans : kClearMeansDerived,
                             configuration.high_pass_order > 0 && !white);
    has_sign_[l] = wants_clear_sign_[l] = wants_all_signs_[l] = false;
    smooth_is_white_[l] = white;
  }
  any_shared_noise_ = false;
  for (const auto& node : configuration.shared_noise)
    for (const auto& weight : node)
      for (const Scaled& noise : weight) any_shared_noise_ = any_shared_noise_ || !noise.is_zero();
  for (bool& locates : locates_crossings_) locates = false;
  any_crossings_ = false;
  for (int n = 0; n < plan_.incidence_count; ++n) {
    const Term& term = configuration.terms[plan_.incidence[n].term];
    if (!is_sign_term(term.kind)) continue;
    has_sign_[term.place] = true;
    const bool clear = plan_.dof[plan_.incidence[n].dof].clear_signs_only;
    (clear ? wants_clear_sign_ : wants_all_signs_)[term.place] = true;
    if (!plan_.dof[plan_.incidence[n].dof].has_acceleration) locates_crossings_[term.place] = any_crossings_ = true;
  }
  restart();
}

void EnergySums::restart() {
  effects_.restart();
  for (ClearSign& sign : clear_sign_) sign.restart();
  for (HighPassedSign& sign : high_passed_sign_) sign.restart();
  for (LowPassedSign& sign : low_passed_sign_) sign.restart();
  started_ = false;
  samples_ = 0;
}

void EnergySums::fill_instruments(Frame& frame, int from, int to) {
  // z = (-v[-2] + 4 v[-1] + 4 v[+1] - v[+2]) / 6 without the division: cubic through the four neighbours.
  for (int node = 0; node < configuration_->dof_count; ++node) {
    const Column<Code> v = frame.codes(signal_column(node, Quantity::kVelocity));
    Column<Code> z = frame.codes(kInstrumentColumn + node);
    for (int i = from; i < to; ++i) z.put(i, 4 * (v[i - 1] + v[i + 1]) - (v[i - 2] + v[i + 2]));
    if (weights_ <= kDisplacement) continue;
    const Column<Code> x = frame.codes(signal_column(node, Quantity::kDisplacement));
    Column<Code> y = frame.codes(kDisplacementInstrumentColumn + node);
    for (int i = from; i < to; ++i) y.put(i, 4 * (x[i - 1] + x[i + 1]) - (x[i - 2] + x[i + 2]));
  }
}

void EnergySums::fill_signs(Frame& frame, int link, int from, int to) {
  const bool smooth_too = weights_ > kInstrument && wants_all_signs_[link];
  for (int stream = 0; stream < (smooth_too ? 2 : 1); ++stream) {
    const Column<Code> sign = frame.codes((stream == 0 ? kSignColumn : kSmoothSignColumn) + link);
    if (!locates_crossings_[link] && equal_units(gains_[link])) {
      signs_of_difference(gains_[link], frame, stream == 1, from, to, sign);
      continue;
    }
    Rate rate[kFrameStride];
    link_rate(gains_[link], frame, stream == 1, from, to, rate);
    signs(rate, from, to, sign);
    if (locates_crossings_[link]) add_crossings(frame, link, stream == 1, rate, from + 1, to - 2);
  }
}

// The equation's weights: the instruments, without the samples in which a friction at the DOF has no clear sign.
void EnergySums::fill_clear_signs(Frame& frame, int from, int to, int advance) {
  for (int i = 0; i < configuration_->dof_count; ++i) {
    if (!plan_.dof[i].clear_signs_only) continue;
    copy(frame, kClearInstrumentColumn + i, kInstrumentColumn + i, from, to);
    if (weights_ > kDisplacement)
      copy(frame, kClearDisplacementColumn + i, kDisplacementInstrumentColumn + i, from, to);
  }
  for (int l = 0; l < configuration_->link_count; ++l) {
    if (!wants_clear_sign_[l]) continue;
    bool clear[kFrameStride];
    const Column<Code> sign = frame.codes(kClearSignColumn + l);
    clear_sign_[l].fill(frame, from, to, advance, clear, sign);
    const int filter = kDerivesSignals ? l : 0;
    if (kDerivesSignals && configuration_->high_pass_order > 0)
      high_passed_sign_[filter].fill(configuration_->high_pass_order, configuration_->high_pass_shift, from, to,
                                     advance, sign, frame.passed_sign(l));
    if (kDerivesSignals && configuration_->sign_half_length > 0)
      low_passed_sign_[filter].fill(*configuration_, from, to, advance, sign, frame.passed_sign(l), clear);
    leave_out(frame, l, from, to, clear);
  }
}

void EnergySums::leave_out(Frame& frame, int link, int from, int to, const bool* clear) {
  const int nodes[2] = {configuration_->links[link].node_a, configuration_->links[link].node_b};
  for (const int i : nodes) {
    if (i >= configuration_->dof_count || !plan_.dof[i].clear_signs_only) continue;
    Column<Code> z = frame.codes(kClearInstrumentColumn + i);
    for (int n = from; n < to; ++n)
      if (!clear[n]) z.put(n, Code{});
    if (weights_ <= kDisplacement) continue;
    Column<Code> y = frame.codes(kClearDisplacementColumn + i);
    for (int n = from; n < to; ++n)
      if (!clear[n]) y.put(n, Code{});
  }
}

void EnergySums::add_crossings(const Frame& frame, int link, bool smoothed, const Rate* rate, int from, int to) {
  for (int n = 0; n < plan_.incidence_count; ++n) {
    const Incidence& incidence = plan_.incidence[n];
    const Term& term = configuration_->terms[incidence.term];
    if (!is_sign_term(term.kind) || term.place != link || plan_.dof[incidence.dof].has_acceleration) continue;
    for (int q = 0; q < weights_; ++q)
      if ((q == kInstrument) == smoothed)
        crossing_[n][q] =
            crossing_[n][q] + crossing_corrections(rate, frame.codes(weight_column(plan_, incidence.dof, q)), from, to);
  }
}

// The end corrections look one sample further on either side of the block.
void EnergySums::fill_columns(Frame& frame, int count) {
  const int from = kLeadIn - 1, to = kLeadIn + count + 2;
  if (!started_) clear_crossings();
  if (weights_ > kInstrument) fill_instruments(frame, from, to);
  for (int l = 0; l < configuration_->link_count; ++l)
    if (has_sign_[l]) fill_signs(frame, l, from, to);
  if (weights_ > kInstrument) fill_clear_signs(frame, from, to, count);
  effects_.fill(frame, from, to, count);
}

EnergySums::EndPoint EnergySums::end_point(const Frame& frame, int at) const {
  EndPoint point;
  for (int i = 0; i < configuration_->dof_count; ++i) {
    point.displacement[i] =
        plan_.dof[i].has_displacement ? frame.codes(signal_column(i, Quantity::kDisplacement))[at].raw : 0;
    point.velocity[i] = plan_.dof[i].has_velocity ? frame.codes(signal_column(i, Quantity::kVelocity))[at].raw : 0;
  }
  return point;
}

void EnergySums::add_block(const Frame& frame, int count) {
  const int to = kLeadIn + count;
  if (!started_) {
    sums_.start(frame, kLeadIn);
    start_ = end_point(frame, kLeadIn);
    samples_ = 0;
    started_ = true;
  }
  sums_.add_block(frame, kLeadIn, to);
  samples_ += static_cast<uint32_t>(count);
}

void EnergySums::clear_crossings() {
  for (int n = 0; n < plan_.incidence_count; ++n)
    for (Crossing& correction : crossing_[n]) correction = Crossing{};
}

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
  const Scaled own = integral(incidence.product_a[weight]) + crossing;
  if (weight != kInstrument) return own;
  const Scaled smooth = integral(incidence.product_smooth) + crossing;
  if (!smooth_is_white_[link]) return smooth;
  return (smooth * Scaled::from_int(200) - own * Scaled::from_int(67)) / Scaled::from_int(133);
}

// Energy per unit mass from the end points.
Scaled EnergySums::kinetic_energy(int dof, int weight) const {
  const DofProducts& products = plan_.dof[dof];
  const int velocity = signal_column(dof, Quantity::kVelocity),
            displacement = signal_column(dof, Quantity::kDisplacement);
  const int64_t v0 = closed_start_.velocity[dof], v1 = closed_end_.velocity[dof];
  if (weight != kDisplacement) {
    const Scaled unit = plan_.column_unit[velocity];
    return unit * unit * Scaled::from_int(v1 * v1 - v0 * v0, -1);
  }
  const int64_t change = closed_end_.displacement[dof] * v1 - closed_start_.displacement[dof] * v0;
  return plan_.column_unit[displacement] * plan_.column_unit[velocity] * Scaled::from_int(change) -
         integral(products.velocity_instrument);
}

Scaled EnergySums::energy(const Incidence& incidence, int weight) const {
  const Term& term = configuration_->terms[incidence.term];
  Scaled result;
  if (term.kind == TermKind::kMass) {
    const bool measured = plan_.dof[incidence.dof].has_acceleration;
    result = measured
                 ? integral(incidence.product_a[weight]) - shared_noise(incidence.dof, weight, Quantity::kAcceleration)
                 : kinetic_energy(incidence.dof, weight);
  } else if (is_sign_term(term.kind)) {
    result = friction_energy(incidence, weight);
  } else {
    result = integral(incidence.product_a[weight]) - integral(incidence.product_b[weight]);
  }
  if (incidence.sign < 0) result = -result;
  if (!any_shared_noise_) return result;
  if (term.kind == TermKind::kViscous) result = result - shared_noise(incidence.dof, weight, Quantity::kVelocity);
  if (term.kind == TermKind::kStiffness) result = result - shared_noise(incidence.dof, weight, Quantity::kDisplacement);
  return result;
}

// Over the samples that the equation counts.
Scaled EnergySums::shared_noise(int dof, int weight, Quantity quantity) const {
  if (!any_shared_noise_) return {};
  const Scaled product = configuration_->shared_noise[dof][weight][static_cast<int>(quantity)];
  if (product.is_zero()) return product;
  const Scaled all = integral(plan_.dof[dof].velocity_instrument), counted = integral(plan_.dof[dof].weight_square);
  const Scaled time = configuration_->sample_period_s * Scaled::from_int(closed_samples_);
  if (weight == kPlain || counted.is_zero() || all.is_zero() || !plan_.dof[dof].clear_signs_only) return product * time;
  return product * time * counted / all;
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
      rhs = rhs - configuration_->terms[incidence.term].value * value;
    }
  }
  dof.rhs[q] = pack(rhs);
  const Scaled unit_v = plan_.column_unit[signal_column(i, Quantity::kVelocity)];
  const Scaled unit_x = plan_.column_unit[signal_column(i, Quantity::kDisplacement)];
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
  if (q != kDisplacement) {
    if (products.has_acceleration) dof.kinetic_discrepancy[q] = pack(integral(products.acceleration[q]) - kinetic_end_);
    if (products.has_displacement) dof.elastic_discrepancy[q] = pack(integral(products.displacement[q]) - elastic_end_);
  } else if (products.has_displacement && products.has_acceleration) {
    dof.kinetic_discrepancy[q] = pack(integral(products.acceleration[q]) + integral(products.velocity_instrument) -
                                      unit_x * unit_v * Scaled::from_int(x1 * v1 - x0 * v0));
  }
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
  converted_ = closing_dof_ = closing_weight_ = 0;
  samples_ = 0;
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
