#include "host_sim/data_check/channel/spikes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/channel/misfit.hpp"
#include "host_sim/data_check/measures/quantile.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kWidest = 3;
constexpr double kDeviations = 8.0;
constexpr double kShareOfRange = 0.02;
constexpr double kOfTheTail = 4.0;  // times the 95 percent quantile: 8 standard deviations again
constexpr double kBeyondAccelerometers = 1e3, kBeyondForceSensors = 1e6;  // times the range of everything else
constexpr double kLoneAcceleration =
    1.5;                               // times what 90 % of the samples span: a contact lasts longer than one sample
constexpr double kBeyondMotion = 5.0;  // times what the velocity spans; an impact turns it round: 1
constexpr double kHarm = 1.02;
constexpr double kWorthSaying = 0.1;  // of the range, where no harm is done

struct Gap {
  size_t first = 0, width = 1;
  double size = 0.0;
};

// Cubic through the two samples before and the two behind a gap of one width: the four samples' weights at the gap's samples.
class Across {
 public:
  explicit Across(size_t width) : width_(width) {
    const double t[4] = {-2.0, -1.0, static_cast<double>(width), static_cast<double>(width + 1)};
    for (size_t k = 0; k < width; ++k)
      for (int i = 0; i < 4; ++i) {
        weight_[k][i] = 1.0;
        for (int j = 0; j < 4; ++j)
          if (j != i) weight_[k][i] *= (static_cast<double>(k) - t[j]) / (t[i] - t[j]);
      }
  }
  double at(const std::vector<double>& x, size_t first, size_t k) const {
    const double* w = weight_[k];
    const double *before = &x[first - 2], *behind = &x[first + width_];
    return w[0] * before[0] + w[1] * before[1] + w[2] * behind[0] + w[3] * behind[1];
  }
  size_t width() const { return width_; }

 private:
  size_t width_;
  double weight_[kWidest][4] = {};
};

double off_left(const std::vector<double>& x, size_t i) {
  return std::abs(x[i] - (3.0 * x[i - 1] - 3.0 * x[i - 2] + x[i - 3]));
}
double off_right(const std::vector<double>& x, size_t i) {
  return std::abs(x[i] - (3.0 * x[i + 1] - 3.0 * x[i + 2] + x[i + 3]));
}

// Does the stretch stand off what either side leads to, are the sides closer to each other, and is each side smooth by
// itself? An edge is no spike, and neither is the crest of a swing that only a few samples show.
bool stands_alone(const std::vector<double>& x, size_t first, size_t width, double size) {
  return std::abs(x[first + width] - x[first - 1]) < 0.5 * size && off_left(x, first) > 0.5 * size &&
         off_right(x, first + width - 1) > 0.5 * size && off_left(x, first - 1) < 0.5 * size &&
         off_right(x, first + width) < 0.5 * size;
}

// How far a stretch stands off the cubic across it.
double size_of(const std::vector<double>& x, size_t first, const Across& across) {
  double size = 0.0;
  for (size_t k = 0; k < across.width(); ++k) size = std::max(size, std::abs(x[first + k] - across.at(x, first, k)));
  return size;
}

// What 95 of 100 stretches of that width are off at most, anywhere in the record.
double tail_of(const std::vector<double>& x, const Across& across) {
  constexpr size_t kStride = 5;
  std::vector<double> sizes;
  sizes.reserve(x.size() / kStride + 1);
  for (size_t i = 4; i + 8 < x.size(); i += kStride) sizes.push_back(size_of(x, i, across));
  return quantile(sizes, 0.95);
}

std::vector<Gap> spikes_in(const std::vector<double>& x, const Statistics& statistics) {
  std::vector<Gap> gaps;
  if (x.size() < 16) return gaps;
  const std::vector<double> misfit = misfits(x);
  const double least = std::max({kShareOfRange * statistics.range, 4.0 * statistics.resolution});
  const Across across[kWidest] = {Across(1), Across(2), Across(3)};
  double tail[kWidest] = {};
  for (size_t k = 0; k < kWidest; ++k) tail[k] = kOfTheTail * tail_of(x, across[k]);
  for (size_t i = 4; i + 8 < x.size(); ++i) {
    if (misfit[i] < 0.3 * least) continue;
    for (size_t width = 1; width <= kWidest; ++width) {
      const double size = size_of(x, i, across[width - 1]);
      if (size < least || size < tail[width - 1] || !stands_alone(x, i, width, size)) continue;
      if (size < kDeviations * std::max(usual_near(misfit, i, width), statistics.resolution)) continue;
      if (is_of_a_ringing(misfit, i, width)) continue;
      gaps.push_back({i, width, size});
      i += width + 3;
      break;
    }
  }
  return gaps;
}

// Stretches of one value between jumps.
std::vector<Gap> dropouts_in(const std::vector<double>& x, const Statistics& statistics) {
  std::vector<Gap> gaps;
  const std::vector<Run> runs = equal_runs(x, kWidest + 1);
  if (runs.empty()) return gaps;
  const std::vector<double> misfit = misfits(x);
  for (const Run& run : runs) {
    const size_t last = run.first + run.length - 1;
    if (run.first < 4 || last + 4 >= x.size()) continue;
    const double in = off_left(x, run.first), out = off_right(x, last);
    const double usual = std::max(usual_near(misfit, run.first, run.length), statistics.resolution);
    const double least = std::max(5.0 * kShareOfRange * statistics.range, 2.0 * kDeviations * usual);
    if (std::min(in, out) > least) gaps.push_back({run.first, run.length, std::min(in, out)});
  }
  return gaps;
}

std::vector<double> repaired(std::vector<double> x, const std::vector<Gap>& gaps) {
  for (const Gap& gap : gaps) {
    const double before = x[gap.first - 1], behind = x[gap.first + gap.width];
    for (size_t k = 0; k < gap.width; ++k)
      x[gap.first + k] = before + (behind - before) * static_cast<double>(k + 1) / static_cast<double>(gap.width + 1);
  }
  return x;
}

// Mean square of the channel, or of its derivative of that order over five samples: about the band of the estimation.
double mean_square(const std::vector<double>& x, int order) {
  constexpr size_t kSpan = 5;
  double sum = 0.0, count = 0.0, mean = 0.0;
  for (const double value : x) mean += value / static_cast<double>(x.size());
  for (size_t i = kSpan; i + kSpan < x.size(); ++i, count += 1.0) {
    const double value = order == 0   ? x[i] - mean
                         : order == 1 ? x[i + kSpan] - x[i - kSpan]
                                      : x[i + kSpan] - 2.0 * x[i] + x[i - kSpan];
    sum += value * value;
  }
  return count > 0.0 ? sum / count : 0.0;
}

// Does a force strike at that sample, or one of its neighbours?
bool struck(const std::vector<KnownChannel>& forces, size_t sample) {
  for (const KnownChannel& force : forces) {
    const std::vector<double>& values = force.channel->values;
    for (size_t i = sample > 2 ? sample - 2 : 0; i < std::min(sample + 3, values.size()); ++i)
      if (std::abs(values[i] - force.statistics->mean) > 3.0 * force.statistics->rms) return true;
  }
  return false;
}

// Of an acceleration or a force: no blow is like that. usual: between the 5 and 95 percent quantiles.
bool impossible(const Gap& gap, Quantity quantity, double usual, const Statistics& statistics,
                const Neighbours& neighbours) {
  if (quantity == Quantity::kAcceleration && gap.width == 1 && gap.size > kLoneAcceleration * usual &&
      !struck(neighbours.forces, gap.first))
    return true;
  const double beyond = quantity == Quantity::kForce ? kBeyondForceSensors : kBeyondAccelerometers;
  if (statistics.range > 0.0 && gap.size > beyond * statistics.range) return true;
  const double change = gap.size * static_cast<double>(gap.width) * neighbours.velocity_step;
  return neighbours.velocity_range > 0.0 && change > kBeyondMotion * neighbours.velocity_range;
}

}  // namespace

std::optional<Finding> find_spikes(const Channel& channel, const Statistics& statistics, const Neighbours& neighbours) {
  const std::vector<double>& x = channel.values;
  std::vector<Gap> gaps = spikes_in(x, statistics);
  const bool continuous = channel.quantity == Quantity::kDisplacement || channel.quantity == Quantity::kVelocity;
  size_t dropouts = 0;
  if (continuous) {
    const std::vector<Gap> more = dropouts_in(x, statistics);
    dropouts = more.size();
    gaps.insert(gaps.end(), more.begin(), more.end());
  } else {
    const auto [low, high] = quantiles(x, 0.05, 0.95);
    const double usual = high - low;
    const auto possible = [&](const Gap& gap) {
      return !impossible(gap, channel.quantity, usual, statistics, neighbours);
    };
    gaps.erase(std::remove_if(gaps.begin(), gaps.end(), possible), gaps.end());
  }
  if (gaps.empty()) return std::nullopt;
  const auto largest =
      std::max_element(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.size < b.size; });
  const std::vector<double> without = repaired(x, gaps);
  double harm = 1.0;
  for (int order = 0; order <= neighbours.differentiated; ++order)
    if (const double clean = mean_square(without, order); clean > 0.0)
      harm = std::max(harm, mean_square(x, order) / clean);
  if (harm <= kHarm && largest->size < kWorthSaying * statistics.range) return std::nullopt;
  std::string text =
      fmt::format("{} {}; the largest at {:.6g} s (sample {}) is {:.3g}, where the rest spans {:.3g}", gaps.size(),
                  dropouts == gaps.size() ? (dropouts == 1 ? "dropout" : "dropouts")
                  : gaps.size() == 1      ? "spike"
                                          : "spikes",
                  static_cast<double>(largest->first) * neighbours.sample_period_s, largest->first + 1,
                  x[largest->first], statistics.range);
  Finding finding;
  finding.kind = "spikes";
  finding.channel = channel.name;
  finding.value = static_cast<double>(gaps.size());
  finding.weight = harm > kHarm ? Weight::kFault : Weight::kDoubt;
  finding.detail = text;
  finding.detail += harm > kHarm ? ": check the cable and the range, then record again or take them out of the file"
                                 : ": too small to matter much";
  return finding;
}

}  // namespace host_sim::data_check
