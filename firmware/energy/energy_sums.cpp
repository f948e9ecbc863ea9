#include "firmware/energy/energy_sums.hpp"

namespace firmware {
namespace {

constexpr int kInstrument = static_cast<int>(Weight::kInstrument);
constexpr int kDisplacement = static_cast<int>(Weight::kDisplacement);

void copy(Frame& frame, int to_column, int from_column, int from, int to) {
  for (int n = from; n < to; ++n) frame.raw[to_column][n] = frame.raw[from_column][n];
}

}  // namespace

void EnergySums::restart(uint32_t time) {
  effects_.restart(time);
  for (ClearSign& sign : clear_sign_) sign.restart();
  for (HighPassedSign& sign : high_passed_sign_) sign.restart();
  for (LowPassedSign& sign : low_passed_sign_) sign.restart();
  started_ = false;
  begin_counts();
}

void EnergySums::begin_counts() {
  samples_ = 0;
  if (!kDerivesSignals) return;
  for (uint32_t& counted : counted_) counted = 0;
}

void EnergySums::fill_instruments(Frame& frame, int from, int to) {
  // z = (-v[-2] + 4 v[-1] + 4 v[+1] - v[+2]) / 6 without the division: cubic through the four neighbours.
  for (int node = 0; node < configuration_->dof_count; ++node) {
    const Column<Code> v = frame.codes(signal_column(node, Quantity::kVelocity));
    Column<Code> z = frame.codes(kInstrumentColumn + node);
    for (int i = from; i < to; ++i) z.put(i, 4 * (v[i - 1] + v[i + 1]) - (v[i - 2] + v[i + 2]));
    if (!kHasDisplacementRows || weights_ <= kDisplacement) continue;
    const Column<Code> x = frame.codes(signal_column(node, Quantity::kDisplacement));
    Column<Code> y = frame.codes(kDisplacementInstrumentColumn + node);
    for (int i = from; i < to; ++i) y.put(i, 4 * (x[i - 1] + x[i + 1]) - (x[i - 2] + x[i + 2]));
  }
}

void EnergySums::fill_signs(Frame& frame, int link, int from, int to) {
  const bool smooth_too = weights_ > kInstrument && use_[link].wants_all_signs;
  for (int stream = 0; stream < (smooth_too ? 2 : 1); ++stream) {
    const Column<Code> sign = frame.codes((stream == 0 ? kSignColumn : kSmoothSignColumn) + link);
    if (!use_[link].locates_crossings && equal_units(gains_[link])) {
      signs_of_difference(gains_[link], frame, stream == 1, from, to, sign);
      continue;
    }
    Rate rate[kFrameStride];
    link_rate(gains_[link], frame, stream == 1, from, to, rate);
    signs(rate, from, to, sign);
    if (use_[link].locates_crossings) add_crossings(frame, link, stream == 1, rate, from + 1, to - 2);
  }
}

// The equation's weights: the instruments, without the samples in which a friction at the DOF has no clear sign.
void EnergySums::fill_clear_signs(Frame& frame, int from, int to, int advance) {
  for (int i = 0; i < configuration_->dof_count; ++i) {
    if (!plan_.dof[i].clear_signs_only) continue;
    copy(frame, kClearInstrumentColumn + i, kInstrumentColumn + i, from, to);
    if (kHasDisplacementRows && weights_ > kDisplacement)
      copy(frame, kClearDisplacementColumn + i, kDisplacementInstrumentColumn + i, from, to);
  }
  for (int l = 0; l < configuration_->link_count; ++l) {
    if (!use_[l].wants_clear_sign) continue;
    bool clear[kFrameStride];
    const Column<Code> sign = frame.codes(kClearSignColumn + l);
    clear_sign_[l].fill(frame, from, to, advance, clear, sign);
    if (kDerivesSignals && configuration_->filters_sign()) filter_sign(frame, l, from, to, advance, clear);
    leave_out(frame, l, from, to, clear);
  }
}

// Through all filters that the other signals pass: the low-pass of derivatives, the high-pass of integrals, or both where the
// DOFs' sensors differ.
void EnergySums::filter_sign(Frame& frame, int link, int from, int to, int advance, bool* clear) {
  const int filter = kDerivesSignals ? link : 0;
  const Column<Code> sign = frame.codes(kClearSignColumn + link);
  Column<PassedSign> passed = frame.passed_sign(link);
  if (configuration_->sign_half_length > 0)
    low_passed_sign_[filter].fill(*configuration_, use_[link].smooth_is_white, from, to, advance, sign, passed, clear);
  else
    for (int n = from; n < to; ++n) passed.put(n, rescale<PassedSign>(sign[n]));
  if (configuration_->high_pass_order > 0)
    high_passed_sign_[filter].fill(configuration_->high_pass_order, configuration_->high_pass_shift, from, to, advance,
                                   passed);
}

void EnergySums::leave_out(Frame& frame, int link, int from, int to, const bool* clear) {
  const int nodes[2] = {configuration_->links[link].node_a, configuration_->links[link].node_b};
  for (const int i : nodes) {
    if (i >= configuration_->dof_count || !plan_.dof[i].clear_signs_only) continue;
    Column<Code> z = frame.codes(kClearInstrumentColumn + i);
    for (int n = from; n < to; ++n)
      if (!clear[n]) z.put(n, Code{});
    if (!kHasDisplacementRows || weights_ <= kDisplacement) continue;
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
    if (use_[l].has_sign) fill_signs(frame, l, from, to);
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
    begin_counts();
    started_ = true;
  }
  sums_.add_block(frame, kLeadIn, to);
  samples_ += static_cast<uint32_t>(count);
  if (!kDerivesSignals || !any_shared_noise_ || weights_ <= kInstrument) return;
  for (int i = 0; i < configuration_->dof_count; ++i) {
    if (!plan_.dof[i].clear_signs_only) continue;
    const int32_t* z = frame.raw[kClearInstrumentColumn + i];
    for (int n = kLeadIn; n < to; ++n) counted_[i] += static_cast<uint32_t>(z[n] != 0);
  }
}

void EnergySums::clear_crossings() {
  for (int n = 0; n < plan_.incidence_count; ++n)
    for (Crossing& correction : crossing_[n]) correction = Crossing{};
}

}  // namespace firmware
