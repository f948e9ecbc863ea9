#include "firmware/warrant/sums/score_sums.hpp"

#include "firmware/energy/product_sums.hpp"
#include "firmware/fixed_point/magnitude.hpp"

namespace firmware {
namespace {

// What a probe's force, a place's motion, a force's slopes and the columns of a link or DOF take, in products a sample
// (measured on a processor with vectors of 256 bits: tests/bench).
constexpr int kForceCost = 4, kMotionCost = 10, kSlopeCost = 16, kColumnCost = 10;
constexpr int kScaleBlocks = 8, kScaleSamplesLog2 = kBlockSamples == 32 ? 8 : 7;
constexpr int kScaleShift = 6;  // Q26 to Q20: squares of 256 samples stay below 2^48
constexpr int kHeadroomBits = 5;

// Of one of the place's equations: what is left of it without the unknown terms.
int known_column(const Place& place, int equation) {
  if (!compares_channels(place.kind)) return kKnownColumn + place.dof[equation];
  const Slope slope = place.kind == PlaceKind::kVelocityChannels ? Slope::kOfDisplacement : Slope::kOfVelocity;
  return slope_rest_column(slope, place.dof[equation]);
}

bool has_friction(const CoreConfiguration& configuration, int link) {
  for (int t = 0; t < configuration.term_count; ++t) {
    const TermKind kind = configuration.terms[t].kind;
    const bool friction =
        kind == TermKind::kCoulomb || kind == TermKind::kStribeck || kind == TermKind::kPreslidingHysteresis;
    if (friction && configuration.terms[t].place == link) return true;
  }
  return false;
}

// Variance of a velocity's noise that its neighbours share: differences between them do not show it. In Q26 of the range.
Scaled slow_rate_noise(const CoreConfiguration& configuration, int node, int32_t range_exponent) {
  const ProbeNoise& noise = configuration.probe_noise[node];
  const Scaled shared =
      noise.motion[static_cast<int>(ProbeWeight::kVelocity)][static_cast<int>(Quantity::kVelocity) - 1];
  return shared.is_negative() ? Scaled{} : scale_by_power_of_two(shared, 2 * (kDifferenceFraction - range_exponent));
}

}  // namespace

void ScoreSums::configure(const CoreConfiguration& configuration, const Scaled* effect_unit, const ClearSigns& signs) {
  configuration_ = &configuration;
  random_ = 1;
  budget_.configure(configuration);
  make_probe_plan(configuration, kMostProbeValues, plan_);
  block_.configure(configuration, effect_unit, signs);
  noise_.configure(configuration, block_.known());
  table_.configure(plan_.value_count, &plan_, scale_);
  int filled = 0;
  for (int p = 0; p < plan_.place_count; ++p)
    for (int j = 0; j < plan_.summed_count; ++j)
      if (plan_.probe[j].place == p) order_[filled++] = static_cast<uint16_t>(j);
  for (int t = 0; t < configuration.term_count; ++t)
    if (configuration.terms[t].unknown >= 0)
      unknown_column_[configuration.terms[t].unknown] =
          static_cast<uint8_t>(block_.column_of(configuration.terms[t], t));
  for (int p = 0; p < plan_.place_count; ++p) {
    const Place& place = plan_.place[p];
    const bool on_dof = moves_by_acceleration(place.kind);
    PlaceScale& scale = scale_[p] = PlaceScale{};
    for (int q = 0; q < 2; ++q) {
      const Quantity quantity = on_dof ? (q == 0 ? Quantity::kAcceleration : Quantity::kForce)
                                       : (q == 0 ? Quantity::kDisplacement : Quantity::kVelocity);
      scale.difference[q] = block_.difference(quantity, place.node_a, on_dof ? kGroundNode : place.node_b);
      scale.present[q] = scale.difference[q].present();
    }
    scale.near_friction =
        place.kind == PlaceKind::kLink && has_friction(configuration, place.link) && !block_.has_clear_sign(place.link);
    for (int e = 0; e < place.equations && scale.near_friction; ++e)
      scale.smeared = scale.smeared || block_.derives_acceleration(place.dof[e]);
  }
  clear();
}

void ScoreSums::clear() {
  offered_ = 0;
  table_.clear();
  forget_squares();
  for (auto& scale : scale_) scale.shift[0] = scale.shift[1] = kLeastScaleShift;
  restart();
}

void ScoreSums::restart() {
  block_.restart();
  busy_ = false;
  credit_ = 0;
}

void ScoreSums::begin_level() {
  restart();
  table_.begin_level();
  time_ = skip_ = 0;
}

void ScoreSums::offer(const Frame& frame, int count) {
  const uint32_t start = time_;
  time_ += static_cast<uint32_t>(count);
  offered_ += static_cast<uint64_t>(count);
  if (configuration_->probe_products_per_sample == 0 || plan_.probe_count == 0) return;
  if (busy_) {  // the block at hand takes longer: the next one starts anew
    block_.restart();
    return;
  }
  if (skip_ > 0) {
    --skip_;
    return;
  }
  for (int from = 0; from < count && !busy_;) {
    from += block_.append(frame, from, count);
    if (!block_.full()) return;
    block_time_ = start + static_cast<uint32_t>(from);
    start_block();
  }
}

void ScoreSums::start_block() {
  block_.fill_neighbours();
  if (outgrown()) forget_squares();
  if (scale_blocks_ < kScaleBlocks) measure_scales();
  block_.fill_columns();
  busy_ = true;
  next_ = 0;
  motion_place_ = -1;
  const int columns = kColumnCost * (configuration_->link_count + configuration_->dof_count);
  needed_ = static_cast<uint32_t>(columns * kBlockSamples) + cost(plan_.probe[order_[0]]);
  if (budget_.whole(time_)) finish();
}

void ScoreSums::forget_squares() {
  scale_blocks_ = 0;
  for (auto& place : square_) place[0] = place[1] = 0;
  for (auto& node : noise_square_) node = 0;
}

void ScoreSums::measure_scales() {
  for (int p = 0; p < plan_.place_count; ++p) {
    for (int q = 0; q < 2; ++q) {
      const NodeDifference& d = scale_[p].difference[q];
      if (!scale_[p].present[q]) continue;
      for (int n = 0; n < kBlockSamples; ++n) {
        const int64_t value = block_.smoothed_at(d, n) >> kScaleShift;
        square_[p][q] += value * value;
      }
    }
    grow_scale(p);
  }
  for (int node = 0; node < kMaxNodes; ++node) {
    if (!configuration_->signals[node][static_cast<int>(Quantity::kVelocity)].available) continue;
    const int32_t* v = block_.signal(signal_column(node, Quantity::kVelocity));
    for (int n = 0; n < kBlockSamples; ++n) {
      const int64_t rest = 6 * int64_t{v[n]} - 4 * (int64_t{v[n - 1]} + v[n + 1]) + (int64_t{v[n - 2]} + v[n + 2]);
      noise_square_[node] += (rest * rest) >> 6;  // 28 bits twice, 256 of them
    }
  }
  ++scale_blocks_;
  set_noise();
}

// The unit of a quantity is the rms of eight blocks, or what is known of it: were they silent that are still to come. So it only grows,
// and a block's largest value is at most the root of 256, 16, of what it makes the unit.
void ScoreSums::grow_scale(int p) {
  PlaceScale& scale = scale_[p];
  const PlaceScale before = scale;
  bool grown = false;
  for (int q = 0; q < 2; ++q) {
    if (square_[p][q] == 0) continue;
    const int rms_log2 = (63 - __builtin_clzll(magnitude(square_[p][q])) - kScaleSamplesLog2) >> 1;
    const int shift = rms_log2 + 1 + kScaleShift - kNormalBits;
    if (shift <= scale.shift[q]) continue;
    scale.shift[q] = static_cast<int8_t>(shift);
    grown = true;
  }
  for (int j = 0; j < plan_.summed_count && grown; ++j) {
    const Probe& probe = plan_.probe[j];
    if (probe.place != p) continue;
    const ProbeExponents now(plan_, probe, scale), then(plan_, probe, before);
    for (int v = 0; v < plan_.values(probe); ++v) table_.rescale(probe.first_value + v, now.of(v) - then.of(v));
  }
}

void ScoreSums::set_noise() {
  const int samples = scale_blocks_ * kBlockSamples;
  for (int p = 0; p < plan_.place_count; ++p) {
    PlaceScale& scale = scale_[p];
    // (6 v - instrument) has 36 + 2 (16 + 1) times the variance of white noise.
    Scaled variance;
    const NodeDifference& rate = scale.difference[1];
    const int32_t gains[2] = {rate.gain_a, rate.gain_b};
    const int nodes[2] = {scale.present[1] && rate.gain_a != 0 ? plan_.place[p].node_a : kGroundNode,
                          scale.present[1] && rate.gain_b != 0 ? plan_.place[p].node_b : kGroundNode};
    for (int e = 0; e < 2; ++e)
      if (nodes[e] < kMaxNodes && !moves_by_acceleration(plan_.place[p].kind)) {
        const Scaled gain = Scaled::from_int(gains[e], -25);
        const Scaled measured = gain * gain * Scaled::ratio(noise_square_[nodes[e]], samples) * Scaled::ratio(64, 70);
        const Scaled slow = slow_rate_noise(*configuration_, nodes[e], rate.range_exponent);
        variance += slow > measured ? slow : measured;
      }
    const int64_t deviation = to_fixed(sqrt(variance), 0);
    scale.noise_q26 = static_cast<int32_t>(deviation > INT32_MAX ? INT32_MAX : deviation);
    if (plan_.place[p].kind == PlaceKind::kLink) block_.set_rate_noise(plan_.place[p].link, scale.noise_q26);
  }
}

// A quantity beyond the headroom of its scale: another one is measured from this block on.
bool ScoreSums::outgrown() const {
  for (int p = 0; p < plan_.place_count; ++p)
    for (int q = 0; q < 2; ++q) {
      const PlaceScale& scale = scale_[p];
      const int bits = kNormalBits + kHeadroomBits + scale.shift[q];
      if (!scale.present[q] || bits >= 26) continue;
      const int64_t most = int64_t{1} << (bits > 0 ? bits : 0);
      const NodeDifference& d = scale.difference[q];
      for (int n = 0; n < kBlockSamples; n += 4)
        if (size_of(block_.smoothed_at(d, n)) > most) return true;
    }
  return false;
}

// In products of two numbers: the force itself, its sums, and once for a place what its forces are made from.
uint32_t ScoreSums::cost(const Probe& probe) const {
  uint32_t products = static_cast<uint32_t>(plan_.values(probe)) + kForceCost;
  if (motion_place_ != probe.place) products += kMotionCost;
  if (kKeepsProbeNoise && plan_.slopes > 0) products += kSlopeCost;
  return products * kBlockSamples;
}

void ScoreSums::go_on() {
  while (busy_ && credit_ >= needed_) {
    credit_ -= needed_;
    work_on(plan_.probe[order_[next_]]);
    if (++next_ == plan_.summed_count) return end_block();
    needed_ = cost(plan_.probe[order_[next_]]);
  }
}

void ScoreSums::work_on(const Probe& probe) {
  const Place& place = plan_.place[probe.place];
  const PlaceScale& scale = scale_[probe.place];
  const bool shares = kKeepsProbeNoise && plan_.slopes > 0;
  const bool edges = shares && place.kind == PlaceKind::kLink && block_.has_clear_sign(place.link);
  if (motion_place_ != probe.place) {
    fill_motion(block_, place, scale, motion_);
    if (edges) find_edges(block_, place, motion_);
  }
  motion_place_ = probe.place;
  alignas(16) int32_t phi[kBlockSamples], own[kBlockSamples];
  fill_force(probe.form, scale, motion_, phi, own);
  const int32_t* with[kPlaceEquations + kMaxPlaceColumns + 1];
  int values = 0;
  for (int e = 0; e < place.equations; ++e) with[values++] = block_.column(known_column(place, e));
  for (int k = 0; k < place.columns; ++k) with[values++] = block_.column(unknown_column_[place.unknown[k]]);
  with[values++] = own;
  add_dots(phi, with, values, &table_.current(probe.first_value));
  const int value = probe.first_value + values - 1;
  if (shares) sum_slopes(probe.form, scale, motion_, edges, &table_.current(value + 1), &table_.current(value + 2));
}

void ScoreSums::end_block() {
  busy_ = false;
  table_.add_block(block_time_);
  if (budget_.whole(time_)) return block_.keep_tail();
  block_.restart();
  random_ = random_ * 1664525u + 1013904223u;
  skip_ = random_ >> 30;  // 0 to 3
}

void ScoreSums::finish() {
  while (busy_) {
    work_on(plan_.probe[order_[next_]]);
    if (++next_ == plan_.summed_count) end_block();
  }
}

Scaled ScoreSums::force_unit(const Probe& probe) const {
  return power_of_two(force_exponent(probe.form, scale_[probe.place]));
}

Scaled ScoreSums::unit(const Probe& probe, int value) const {
  const Place& place = plan_.place[probe.place];
  const Scaled own = force_unit(probe);
  if (value < place.equations) return own * block_.column_unit(known_column(place, value));
  value -= place.equations;
  if (value < place.columns) return own * block_.column_unit(unknown_column_[place.unknown[value]]);
  if (value == place.columns) return own * own;
  return own * power_of_two(-1 - kSlopeStepLog2 - quantity_exponent(scale_[probe.place], value - place.columns - 1));
}

Scaled ScoreSums::noise_share(const Probe& probe, int slope, int value, SharedNoise::Of of) const {
  if (!kKeepsProbeNoise) return {};
  const Place& place = plan_.place[probe.place];
  if (value < place.equations) return noise_.with_known(place, probe.form, slope, place.dof[value], of);
  return noise_.with_column(place, probe.form, slope, unknown_column_[place.unknown[value - place.equations]], of);
}

}  // namespace firmware
