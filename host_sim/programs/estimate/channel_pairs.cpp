#include "host_sim/programs/estimate/channel_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "host_sim/data_check/one_motion/comparison.hpp"
#include "host_sim/programs/estimate/delay_or_corner.hpp"

namespace host_sim {
namespace {

constexpr double kClear = 8.0;  // deviations
constexpr double kMostPeriods = 3.0, kMostGain = 0.2;

// Of the acceleration against the displacement, over all records.
struct Pair {
  const Channel *displacement = nullptr, *acceleration = nullptr;
  double late_s = 0.0, late_std_s = 0.0, gain = 0.0, gain_std = 0.0;
  DelayAndCorner lead;
  double delays() const { return late_std_s > 0.0 ? std::abs(late_s) / late_std_s : 0.0; }
  double gains() const { return gain_std > 0.0 ? std::abs(gain) / gain_std : 0.0; }
};

// Both sides of x'' = a over a span of 2h samples, weighted by a triangle:
//   (x[i+h] - 2 x[i] + x[i-h]) / (h T)^2  and the same mean of (a[-1] + 10 a[0] + a[1]) / 12 (Numerov: to the fourth order in T).
struct Sides {
  std::vector<double> of_x, of_a;
};

Sides sides_over(const std::vector<double>& x, const std::vector<double>& a, double T, size_t h) {
  const size_t n = x.size();
  std::vector<double> sum(n + 1, 0.0), twice(n + 2, 0.0);  // of a, and of its sums
  for (size_t i = 1; i + 1 < n; ++i) sum[i + 1] = sum[i] + (a[i - 1] + 10.0 * a[i] + a[i + 1]) / 12.0;
  sum[n] = sum[n - 1];
  for (size_t i = 0; i <= n; ++i) twice[i + 1] = twice[i] + sum[i];
  Sides sides;
  const double span = static_cast<double>(h) * T, squared = static_cast<double>(h * h);
  for (size_t i = h + 1; i + h + 1 < n; ++i) {
    sides.of_x.push_back((x[i + h] - 2.0 * x[i] + x[i - h]) / (span * span));
    // sum over j of (h - |j|) a[i + j]: a second difference of the sums of sums
    sides.of_a.push_back((twice[i + h + 1] - 2.0 * twice[i + 1] + twice[i + 1 - h]) / squared);
  }
  return sides;
}

double product(const std::vector<double>& one, const std::vector<double>& other, size_t from, size_t to, size_t lag) {
  double sum = 0.0;
  for (size_t i = from; i + lag < to; ++i) sum += one[i] * other[i + lag];
  return sum;
}

struct Gain {
  double value = 0.0, std = 0.0;
};

// Where the two sides agree best; half 0: the record is too short to say.
struct BestSides {
  Sides sides;
  size_t half = 0;
};
BestSides best_sides(const std::vector<double>& x, const std::vector<double>& a, double T) {
  constexpr size_t kLongest = 32;
  BestSides best;
  if (x.size() < 64 * kLongest) return best;
  double most = 0.0;
  for (size_t h = 1; h <= kLongest; h *= 2) {
    Sides sides = sides_over(x, a, T, h);
    const size_t n = sides.of_x.size();
    const double shared = product(sides.of_x, sides.of_a, 0, n, 0);
    const double powers = product(sides.of_x, sides.of_x, 0, n, 0) * product(sides.of_a, sides.of_a, 0, n, 0);
    if (!(powers > 0.0) || shared * shared / powers <= most) continue;
    most = shared * shared / powers;
    best = {std::move(sides), h};
  }
  return best;
}

// Acceleration over the displacement's slope's slope, less 1: from products of samples so far apart that white noise has no part in
// them. The deviation comes from the scatter of sixteen parts of the record.
std::optional<Gain> gain_of(const BestSides& at) {
  constexpr size_t kParts = 16;
  const auto& [best, half] = at;
  if (half == 0) return std::nullopt;
  const size_t n = best.of_x.size(), first = 2 * half + 3;
  size_t lag = first;
  double largest = 0.0;
  for (size_t l = first; l < 3 * first + 16; ++l) {
    const double size = std::abs(product(best.of_x, best.of_x, 0, n, l));
    if (size > largest) largest = size, lag = l;
  }
  std::vector<double> numerator(kParts), denominator(kParts);
  double above = 0.0, below = 0.0, squares = 0.0;
  for (size_t part = 0; part < kParts; ++part) {
    const size_t from = part * n / kParts, to = (part + 1) * n / kParts;
    numerator[part] = product(best.of_x, best.of_a, from, to, lag) + product(best.of_a, best.of_x, from, to, lag);
    denominator[part] = 2.0 * product(best.of_x, best.of_x, from, to, lag);
    above += numerator[part];
    below += denominator[part];
  }
  if (below == 0.0) return std::nullopt;
  Gain gain;
  gain.value = above / below - 1.0;
  for (size_t part = 0; part < kParts; ++part) {
    const double off = numerator[part] - above / below * denominator[part];
    squares += off * off;
  }
  gain.std = std::sqrt(squares * kParts / (kParts - 1)) / std::abs(below);
  return gain;
}

// Means of the records, weighted by what each of them knows.
Pair compare_pair(const std::vector<Record>& records, int dof) {
  Pair pair;
  pair.displacement = records.front().find(Quantity::kDisplacement, dof);
  pair.acceleration = records.front().find(Quantity::kAcceleration, dof);
  if (pair.displacement == nullptr || pair.acceleration == nullptr) return pair;
  double delay_weight = 0.0, gain_weight = 0.0;
  for (const Record& record : records) {
    const Channel &x = *record.find(Quantity::kDisplacement, dof), &a = *record.find(Quantity::kAcceleration, dof);
    data_check::Integrals integrals;
    const auto found = data_check::compare(x, a, record.sample_period_s, integrals);
    const BestSides sides = best_sides(x.values, a.values, record.sample_period_s);
    const auto gain = gain_of(sides);
    if (!found || !gain || !(found->late_std_s > 0.0) || !(gain->std > 0.0) || found->turned) continue;
    const double by_delay = 1.0 / (found->late_std_s * found->late_std_s), by_gain = 1.0 / (gain->std * gain->std);
    pair.lead.add(sides.sides.of_x, sides.sides.of_a, record.sample_period_s);
    pair.late_s += by_delay * found->late_s;
    pair.gain += by_gain * gain->value;
    delay_weight += by_delay;
    gain_weight += by_gain;
  }
  if (!(delay_weight > 0.0)) return pair;
  pair.late_s /= delay_weight;
  pair.late_std_s = 1.0 / std::sqrt(delay_weight);
  pair.gain /= gain_weight;
  pair.gain_std = 1.0 / std::sqrt(gain_weight);
  return pair;
}

ChannelCorrection correction_of(const Channel& channel, double late_s, double late_std_s, double gain,
                                double gain_std) {
  ChannelCorrection correction;
  correction.channel = channel.name;
  correction.late_us = 1e6 * late_s;
  correction.gain = gain;
  correction.std = gain != 0.0 ? gain_std : 1e6 * late_std_s;
  correction.by_channels = false;
  return correction;
}

}  // namespace

bool measures_velocity(const std::vector<Record>& records, int dof) {
  return records.front().find(Quantity::kVelocity, dof) != nullptr;
}

std::vector<ChannelCorrection> pair_corrections(const std::vector<Record>& records) {
  Pair worst;
  for (const Channel& channel : records.front().channels) {
    if (channel.quantity != Quantity::kDisplacement || measures_velocity(records, channel.dof)) continue;
    const Pair pair = compare_pair(records, channel.dof);
    if (std::max(pair.delays(), pair.gains()) > std::max(worst.delays(), worst.gains())) worst = pair;
  }
  if (worst.delays() > kClear && worst.delays() > worst.gains()) {
    if (std::abs(worst.late_s) > kMostPeriods * records.front().sample_period_s) return {};
    const ChannelCorrection late = correction_of(*worst.displacement, -worst.late_s, worst.late_std_s, 0.0, 0.0);
    if (worst.late_s < 0.0)  // as behind a high-pass, by less the faster it is
      return worst.lead.is_a_delay() ? std::vector<ChannelCorrection>{late} : std::vector<ChannelCorrection>{};
    return {late, correction_of(*worst.acceleration, worst.late_s, worst.late_std_s, 0.0, 0.0)};
  }
  if (worst.gains() < kClear || std::abs(worst.gain) > kMostGain) return {};
  return {correction_of(*worst.displacement, 0.0, 0.0, 1.0 / (1.0 + worst.gain) - 1.0, worst.gain_std),
          correction_of(*worst.acceleration, 0.0, 0.0, worst.gain, worst.gain_std)};
}

}  // namespace host_sim
