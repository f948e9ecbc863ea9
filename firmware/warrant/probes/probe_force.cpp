#include "firmware/warrant/probes/probe_force.hpp"

#include "firmware/fixed_point/wider_vectors.hpp"
#include "firmware/warrant/probes/force_law.hpp"

namespace firmware {
namespace {

constexpr int64_t kMost = 32 * kProbeUnit;
constexpr int kEdgeBits = 12;
constexpr int32_t kLeastChange = kProbeUnit >> 8;  // of a rate, a sample

// A block's numbers, Q26 of the range, to Q18 of the rms.
void normalise(int shift, int32_t (&number)[kBlockSamples]) {
  const int right = shift > 0 ? shift : 0;
  const int64_t times = int64_t{1} << (shift < 0 ? -shift : 0);
  for (int32_t& one : number) one = static_cast<int32_t>(limited((one * times) >> right, kMost));
}

// Friction's jump lies within the reach of the slope that made the acceleration, which then holds a part of either side. Told
// by the slope's outermost samples: they have a 200th of its weight, so that the choice hardly knows the noise of the slope.
bool across_a_reversal(const NodeDifference& rate, const int32_t* a, const int32_t* b, int n) {
  const int32_t before = difference_at(rate, a, b, n - kNeighbours), after = difference_at(rate, a, b, n + kNeighbours);
  return (before > 0) != (after > 0);
}

// A rate in Q26 of the range, in Q18 of its rms.
[[gnu::noinline]] int64_t normal_rate(const PlaceScale& scale, int64_t rate_q26) {
  return scale.shift[1] >= 0 ? rate_q26 >> scale.shift[1] : rate_q26 << -scale.shift[1];
}
int64_t rate_noise(const PlaceScale& scale) { return normal_rate(scale, scale.noise_q26); }

// own: the difference of the place's nodes where the equations have it as a column.
void fill_quantity(const BlockMotion& block, const PlaceScale& scale, int q, const int32_t* own, PlaceMotion& motion) {
  const NodeDifference& d = scale.difference[q];
  const int32_t *a = block.signal(d.column_a), *b = block.signal(d.column_b);
  const int32_t *near_a = block.between_neighbours(d.column_a), *near_b = block.between_neighbours(d.column_b);
  for (int n = 0; n < kBlockSamples; ++n) motion.instrument[q][n] = smoothed(d, near_a[n], near_b[n]);
  for (int n = 0; n < kBlockSamples; ++n) motion.own[q][n] = own != nullptr ? own[n] : difference_at(d, a, b, n);
  normalise(scale.shift[q], motion.instrument[q]);
  normalise(scale.shift[q], motion.own[q]);
}

const int32_t* own_column(const BlockMotion& block, const Place& place, int q) {
  if (place.kind == PlaceKind::kLink) return block.column((q == 0 ? kElongationColumn : kRateColumn) + place.link);
  return place.kind == PlaceKind::kDof && q == 0 ? block.column(kAccelerationColumn + place.node_a) : nullptr;
}

// Only a DOF's probes ask for slopes: its quantity has one end.
void fill_slopes(const BlockMotion& block, const PlaceScale& scale, int q, PlaceMotion& motion) {
  const NodeDifference& d = scale.difference[q];
  const int32_t *a = block.signal(d.column_a), *b = block.signal(d.column_b);
  for (int n = 0; n < kBlockSamples; ++n) {
    motion.slope[q][n] = slope(d, a, n);
    motion.own_slope[q][n] = difference_at(d, a, b, n + 1) / 2 - difference_at(d, a, b, n - 1) / 2;
  }
  normalise(scale.shift[q], motion.slope[q]);
  normalise(scale.shift[q], motion.own_slope[q]);
}

void fill_used(const BlockMotion& block, const Place& place, const PlaceScale& scale, PlaceMotion& motion) {
  for (int32_t& used : motion.used) used = -1;
  for (int e = 0; e < place.equations; ++e)
    if (block.leaves_out(place.dof[e]))
      for (int n = 0; n < kBlockSamples; ++n)
        if (!block.counts(place.dof[e], n)) motion.used[n] = 0;
  if (scale.near_friction) {
    const int64_t limit = normal_rate(scale, int64_t{kReversalDeviations} * scale.noise_q26);
    for (int n = 0; n < kBlockSamples; ++n)
      if (size_of(motion.instrument[1][n]) <= limit) motion.used[n] = 0;
  }
  if (!scale.smeared) return;
  const NodeDifference& rate = scale.difference[1];
  const int32_t *a = block.signal(rate.column_a), *b = block.signal(rate.column_b);
  for (int n = 0; n < kBlockSamples; ++n)
    if (across_a_reversal(rate, a, b, n)) motion.used[n] = 0;
}

// A straight line over +-5/4 standard deviations of the rate's noise.
void fill_own_sign(const PlaceScale& scale, PlaceMotion& motion) {
  const int64_t noise = rate_noise(scale), width = noise + noise / 4;
  for (int n = 0; n < kBlockSamples; ++n) {
    motion.own_sign[n] = soft_sign(motion.own[1][n], width, kSignBits);
  }
}

// What a rate made from the neighbours says of its direction: nothing, close to a reversal; and of a law that is over where signs are
// known nothing at all.
void fill_direction(Form form, const int32_t* w, int64_t noise, int32_t* direction) {
  const int64_t close = kReversalDeviations * noise;
  const bool unknown = close > INT32_MAX || (form == Form::kSignNarrow && close > kNarrowRate);
  const auto limit = static_cast<int32_t>(unknown ? INT32_MAX : close);
  for (int n = 0; n < kBlockSamples; ++n) {
    const int32_t way = w[n] < 0 ? -(1 << kSignBits) : 1 << kSignBits;
    direction[n] = (w[n] < 0 ? -w[n] : w[n]) <= limit ? 0 : way;
  }
}

// From the neighbours.
void fill_instrument(Form form, const PlaceScale& scale, const int32_t (&quantity)[2][kBlockSamples],
                     const int32_t* used, int32_t* force) {
  int32_t direction[kBlockSamples];
  if (has_sign(form)) fill_direction(form, quantity[1], rate_noise(scale), direction);
  fill_law(form, quantity, direction, used, force);
}

}  // namespace

// |w| falls into the run, or rises out of it, near its own reversal: other links' runs are not its own rate's choice.
void find_edges(const BlockMotion& block, const Place& place, PlaceMotion& motion) {
  const int32_t* w = motion.instrument[1];
  const auto counts = [&](int n) {
    for (int e = 0; e < place.equations; ++e)
      if (block.leaves_out(place.dof[e]) && !block.counted(place.dof[e], n)) return false;
    return true;
  };
  for (int n = 0; n < kBlockSamples; ++n) {
    int32_t& edge = motion.slope[0][n] = 0;
    if (motion.used[n] == 0 || size_of(w[n]) > kProbeUnit) continue;
    const int before = n > 0 ? n - 1 : n, behind = n + 1 < kBlockSamples ? n + 1 : n;
    const bool rises = size_of(w[behind]) > size_of(w[before]);
    if (counts(rises ? n - 1 : n + 1)) continue;
    const int from = n < 2 ? 0 : n - 2, to = n + 2 < kBlockSamples ? n + 2 : kBlockSamples - 1;
    const int32_t change = static_cast<int32_t>(size_of(w[to] - w[from])) / (to - from);  // |w| is at most 2^23
    const int32_t weight = (2 << (kSlopeStepLog2 + kEdgeBits)) / (change < kLeastChange ? kLeastChange : change);
    edge = w[n] < 0 ? -weight : weight;
  }
}

FIRMWARE_WIDEST_VECTORS void fill_motion(const BlockMotion& block, const Place& place, const PlaceScale& scale,
                                         PlaceMotion& motion) {
  for (int q = 0; q < 2; ++q) {
    if (!scale.present[q]) {
      for (int n = 0; n < kBlockSamples; ++n)
        motion.instrument[q][n] = motion.own[q][n] = motion.slope[q][n] = motion.own_slope[q][n] = 0;
      continue;
    }
    fill_quantity(block, scale, q, own_column(block, place, q), motion);
    if (place.kind == PlaceKind::kDof) fill_slopes(block, scale, q, motion);
  }
  fill_used(block, place, scale, motion);
  if (place.kind != PlaceKind::kDof) fill_own_sign(scale, motion);
}

FIRMWARE_WIDEST_VECTORS void fill_force(Form form, const PlaceScale& scale, const PlaceMotion& motion, int32_t* phi,
                                        int32_t* own) {
  if (is_slope(form)) {
    const int q = form == Form::kJerk ? 0 : 1;
    for (int n = 0; n < kBlockSamples; ++n) {
      phi[n] = motion.slope[q][n] & motion.used[n];
      own[n] = motion.own_slope[q][n] & motion.used[n];
    }
    return;
  }
  fill_instrument(form, scale, motion.instrument, motion.used, phi);
  fill_law(form, motion.own, motion.own_sign, motion.used, own);
}

void sum_slopes(Form form, const PlaceScale& scale, const PlaceMotion& motion, bool edges, int64_t* first,
                int64_t* second) {
  constexpr int32_t h = 1 << kSlopeStepLog2;
  if (is_slope(form)) {
    for (const int32_t used : motion.used) *first += used == 0 ? 0 : 2 * h;
    return;
  }
  int32_t moved[2][kBlockSamples], force[kBlockSamples];
  const auto move = [&](int q, int32_t by) {
    for (int n = 0; n < kBlockSamples; ++n) moved[q][n] = motion.instrument[q][n] + by;
  };
  const auto sum_at = [&](int q, int32_t by) {
    move(q, by);
    fill_instrument(form, scale, moved, motion.used, force);
    int64_t sum = 0;
    for (const int32_t one : force) sum += one;
    return sum;
  };
  move(1, 0);
  *first += sum_at(0, h) - sum_at(0, -h);
  move(0, 0);
  *second += sum_at(1, h) - sum_at(1, -h);
  if (!edges) return;
  fill_instrument(form, scale, motion.instrument, motion.used, force);
  for (int n = 0; n < kBlockSamples; ++n) *second += (int64_t{force[n]} * motion.slope[0][n]) >> kEdgeBits;
}

int32_t quantity_exponent(const PlaceScale& scale, int quantity) {
  return scale.difference[quantity].range_exponent - kDifferenceFraction + kTableScaleShift;
}

int32_t force_exponent(Form form, const PlaceScale& scale) {
  const Powers power = powers_of(form);
  const int cubic = power.of[0] + power.of[1];
  int32_t exponent = cubic == 3 ? 45 : cubic == 2 ? 22 : cubic == 1 ? 0 : -kSignBits;
  if (form == Form::kForceWithinGap) exponent = 3 - kProbeFraction;
  for (int q = 0; q < 2; ++q)
    if (power.of[q] > 0) exponent += power.of[q] * quantity_exponent(scale, q);
  return exponent;
}

}  // namespace firmware
