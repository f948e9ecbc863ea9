#include "host_sim/data_check/spikes/gaps.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/measures/quantile.hpp"
#include "host_sim/data_check/spikes/misfit.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kWidest = 3;
constexpr size_t kStart = 4, kEnd = 8;  // samples that have no neighbours enough on either side
constexpr double kDeviations = 8.0;
constexpr double kShareOfRange = 0.02;
constexpr double kOfTheTail = 4.0;  // times the 95 percent quantile: 8 standard deviations again

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
  for (size_t i = kStart; i + kEnd < x.size(); i += kStride) sizes.push_back(size_of(x, i, across));
  return quantile(sizes, 0.95);
}

// A sensor that holds its values and stands still on its way from one direction to the other.
bool passed_by_steps(const std::vector<double>& x, size_t first, size_t last) {
  const double before = x[first - 1], after = x[last + 1];
  if (last + kWidest + 1 >= x.size() || !((before - x[first]) * (after - x[first]) < 0)) return false;
  for (size_t k = 2; k <= kWidest + 1; ++k)
    if (x[first - k] != before || x[last + k] != after) return false;
  return true;
}

}  // namespace

std::vector<Gap> ends_off(const std::vector<double>& x) {
  std::vector<Gap> gaps;
  if (x.size() < 4 * (kStart + kEnd)) return gaps;
  const auto [lowest, highest] =
      std::minmax_element(x.begin() + static_cast<std::ptrdiff_t>(kStart), x.end() - static_cast<std::ptrdiff_t>(kEnd));
  const double low = *lowest, high = *highest, range = high - low;
  const auto size_at = [&](size_t i) { return std::max(x[i] - high, low - x[i]); };
  // a start from rest is as far off, but the samples behind it lead there, or those on either side
  const auto led_to = [&](size_t i) {
    if ((i < kStart ? off_right(x, i) : off_left(x, i)) < range) return true;
    return i > 0 && i + 1 < x.size() && std::abs(x[i] - 0.5 * (x[i - 1] + x[i + 1])) < range;
  };
  const auto take = [&](size_t from, size_t to) {
    for (size_t i = from; i < to; ++i) {
      if (!(range > 0.0 && size_at(i) > range) || led_to(i)) continue;
      const bool on = !gaps.empty() && gaps.back().first + gaps.back().width == i;
      if (!on) gaps.push_back({i, 0, 0.0});
      ++gaps.back().width, gaps.back().size = std::max(gaps.back().size, size_at(i));
    }
  };
  take(0, kStart), take(x.size() - kEnd, x.size());
  return gaps;
}

std::vector<Gap> spikes_in(const std::vector<double>& x, const Statistics& statistics) {
  std::vector<Gap> gaps;
  if (x.size() < 16) return gaps;
  const std::vector<double> misfit = misfits(x);
  const double least = std::max({kShareOfRange * statistics.range, 4.0 * statistics.resolution});
  const Across across[kWidest] = {Across(1), Across(2), Across(3)};
  double tail[kWidest] = {};
  for (size_t k = 0; k < kWidest; ++k) tail[k] = kOfTheTail * tail_of(x, across[k]);
  for (size_t i = kStart; i + kEnd < x.size(); ++i) {
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

std::vector<Gap> dropouts_in(const std::vector<double>& x, const Statistics& statistics) {
  std::vector<Gap> gaps;
  const std::vector<Run> runs = equal_runs(x, kWidest + 1);
  if (runs.empty()) return gaps;
  const std::vector<double> misfit = misfits(x);
  for (const Run& run : runs) {
    const size_t last = run.first + run.length - 1;
    if (run.first < 4 || last + 4 >= x.size() || passed_by_steps(x, run.first, last)) continue;
    const double in = off_left(x, run.first), out = off_right(x, last);
    const double usual = std::max(usual_near(misfit, run.first, run.length), statistics.resolution);
    const double least = std::max(5.0 * kShareOfRange * statistics.range, 2.0 * kDeviations * usual);
    if (std::min(in, out) > least) gaps.push_back({run.first, run.length, std::min(in, out)});
  }
  return gaps;
}

}  // namespace host_sim::data_check
