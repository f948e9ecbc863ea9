#include "hal/rig_file/recorded/channel_noise.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/recorded/filtered_noise.hpp"

namespace rig_file {
namespace {

using Taps = std::vector<double>;

constexpr int kDisplacement = static_cast<int>(firmware::Quantity::kDisplacement);
constexpr double kPi = 3.14159265358979323846;
constexpr double kMedianOfNormal = 0.6745;                 // of the magnitude, in standard deviations
constexpr double kClip = 3.0, kClippedVariance = 0.97334;  // variance of a normal variable within +-3 deviations

// A level read from n samples is known to sqrt(2 / n) of its band: 2 % for 5000 samples.
constexpr double kWhiteDoubt = 0.04;
// The upper half of the spectrum hardly tells poles over 0.7 apart. Of a displacement, whose slopes are what noise is
// in, the same band counts. What is integrated has the noise of low frequencies: that is read there (kLowDoubt).
constexpr double kColouredDoubt = 0.25, kMostPole = 0.9;
// A bottom of the spectrum that is so far above the top is coloured: the least of 8 bands scatters by a half.
constexpr double kColouredLevel = 3.0, kLowDoubt = 0.5;
// What is within 0.1 of white is taken for white: three times the pole's deviation from 20000 samples.
constexpr double kWhitePole = 0.1;
// Order of the differences that a channel's bands are made of. A jump of an acceleration or of a force stands in one sample more than the
// order; motion of ten samples a period passes order 4 with a seventh of itself, order 8 with a fiftieth. So the lowest one counts
// that shows white noise.
constexpr int kLeastOrder = 4, kOrderOfDisplacement = 8, kMostOrder = 16;
constexpr size_t kLeastSegment = 4096;  // of the bottom of the spectrum, samples
// A power that misses the first-order curve by more is not of such noise.
constexpr double kMisfit = 0.15;

// Noise that does not show in the codes is at most that of their rounding: deviation of an even distribution over one code.
constexpr double kRounding = 0.2887;

Taps times_one_plus_shift(const Taps& h) {
  Taps out(h.size() + 1, 0.0);
  for (size_t i = 0; i < h.size(); ++i) out[i] += h[i], out[i + 1] += h[i];
  return out;
}

// (1 - B)^order (1 + B)^sums: the larger sums is, the lower is its band; 0: the top of the spectrum.
Taps band(int order, int sums) {
  Taps h{1.0};
  for (int i = 0; i < order; ++i) {
    Taps next(h.size() + 1, 0.0);
    for (size_t k = 0; k < h.size(); ++k) next[k] += h[k], next[k + 1] -= h[k];
    h = next;
  }
  for (int i = 0; i < sums; ++i) h = times_one_plus_shift(h);
  return h;
}

// Power of the filter's output for first-order noise of unit variance.
double gain(const Taps& h, double pole) {
  Taps power(h.size());
  for (size_t lag = 0; lag < h.size(); ++lag) power[lag] = std::pow(pole, static_cast<double>(lag));
  double sum = 0;
  for (size_t i = 0; i < h.size(); ++i)
    for (size_t k = 0; k < h.size(); ++k) sum += h[i] * h[k] * power[i < k ? k - i : i - k];
  return sum;
}

double mean_square(const std::vector<double>& values, double below) {
  double sum = 0;
  size_t count = 0;
  for (double v : values)
    if (v <= below) sum += v * v, ++count;
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

// Mean square of the filter's output. A displacement has no jumps, even its second slope alone jumps with friction: there
// rare large errors count, as they do in products of noise. In other channels a jump is motion and is clipped.
double power(const ChannelCodes& records, int q, const Taps& h) {
  std::vector<double> magnitudes;
  for (const auto& record : records) {
    if (record.size() < h.size()) continue;
    std::vector<double> sum(record.size() - h.size() + 1, 0.0);
    for (size_t k = 0; k < h.size(); ++k)
      for (size_t n = 0; n < sum.size(); ++n) sum[n] += h[k] * record[n + k];
    for (const double value : sum) magnitudes.push_back(std::fabs(value));
  }
  if (magnitudes.empty()) return 0.0;
  if (q == kDisplacement) return mean_square(magnitudes, INFINITY);
  const auto middle = magnitudes.begin() + static_cast<long>(magnitudes.size() / 2);
  std::nth_element(magnitudes.begin(), middle, magnitudes.end());
  double deviation = *middle / kMedianOfNormal;
  for (int turn = 0; turn < 8; ++turn)
    deviation = std::sqrt(mean_square(magnitudes, kClip * deviation) / kClippedVariance);
  return deviation * deviation;
}

// The pole at which the two bands' powers have their ratio.
double pole_of(const Taps& top, const Taps& lower, double ratio) {
  double least = -0.5, most = kMostPole;
  for (int turn = 0; turn < 40; ++turn) {
    const double middle = 0.5 * (least + most);
    (gain(lower, middle) / gain(top, middle) < ratio ? least : most) = middle;
  }
  return 0.5 * (least + most);
}

// Powers in the three bands, the top of the spectrum first.
struct Bands {
  explicit Bands(int highest_order)
      : order(highest_order), filter{band(order, 0), band(order, order / 2), band(order, order)} {}
  int order;
  Taps filter[3];
  void read(const ChannelCodes& records, int quantity) {
    for (int b = 0; b < 3; ++b) power[b] = rig_file::power(records, quantity, filter[b]);
  }
  double pole(int b) const { return pole_of(filter[0], filter[b], power[b] / power[0]); }
  bool fits(double pole) const {
    for (int b = 1; b < 3; ++b)
      if (std::fabs(power[b] / power[0] * gain(filter[0], pole) / gain(filter[b], pole) - 1.0) > kMisfit) return false;
    return true;
  }
  bool white() const { return fits(0.0) || std::fabs(pole(2)) < kWhitePole; }
  double power[3] = {};
};

Bands telling_bands(const ChannelCodes& records, int quantity) {
  Bands first(quantity == kDisplacement ? kOrderOfDisplacement : kLeastOrder);
  first.read(records, quantity);
  for (int order = 2 * first.order; !first.white() && order <= kMostOrder; order *= 2) {
    Bands narrow(order);
    narrow.read(records, quantity);
    if (narrow.white()) return narrow;
  }
  return first;
}

// Variance of white noise that would have the power which the channel has where it has least, between 2 and 24 periods in a
// segment of four seconds, of 4096 samples where these are longer (a slow rig is sampled slowly), or of a fifth of the longest record:
// a bound for noise at low frequencies. 0: the records are too short.
double low_level(const ChannelCodes& records, double rate_Hz) {
  size_t longest = 0;
  for (const auto& record : records) longest = std::max(longest, record.size());
  const size_t length = std::min(std::max(static_cast<size_t>(4 * rate_Hz), kLeastSegment), longest / 5);
  if (length < 128) return 0.0;
  constexpr int kFirst = 2, kBands = 8, kLines = 3;
  double band_power[kBands] = {};
  double window_power = 0;
  size_t segments = 0;
  std::vector<double> window(length), cosines, sines;  // of all lines, one after the other
  for (size_t n = 0; n < length; ++n) {
    window[n] = 0.5 - 0.5 * std::cos(2 * kPi * (static_cast<double>(n) + 0.5) / static_cast<double>(length));
    window_power += window[n] * window[n];
  }
  for (int line = 0; line < kBands * kLines; ++line) {
    const double step = 2 * kPi * (kFirst + line) / static_cast<double>(length);
    for (size_t n = 0; n < length; ++n) {
      cosines.push_back(std::cos(step * static_cast<double>(n)));
      sines.push_back(std::sin(step * static_cast<double>(n)));
    }
  }
  for (const auto& record : records)
    for (size_t from = 0; from + length <= record.size(); from += length / 2, ++segments)
      for (int line = 0; line < kBands * kLines; ++line) {
        const double* const turn = cosines.data() + static_cast<size_t>(line) * length;
        const double* const quarter = sines.data() + static_cast<size_t>(line) * length;
        double cosine = 0, sine = 0, middle = record[from];
        for (size_t n = 0; n < length; ++n) {
          const double value = window[n] * (record[from + n] - middle);
          cosine += value * turn[n];
          sine += value * quarter[n];
        }
        band_power[line / kLines] += cosine * cosine + sine * sine;
      }
  if (segments == 0) return 0.0;
  return *std::min_element(band_power, band_power + kBands) / (static_cast<double>(kLines * segments) * window_power);
}

// The pole whose noise has the power at the top of the spectrum and at its bottom, where sums of it grow (1 + pole) / (1 - pole)
// times faster than those of white noise.
double pole_between(const Taps& top, double top_power, double low) {
  double least = 0.0, most = kMostPole;
  for (int turn = 0; turn < 40; ++turn) {
    const double middle = 0.5 * (least + most);
    ((1 + middle) / (1 - middle) / gain(top, middle) < low / top_power ? least : most) = middle;
  }
  return 0.5 * (least + most);
}

// Noise that differs between records is not what is read of all.
double spread(const ChannelCodes& records, int quantity, const Taps& top, double whole) {
  double most = 0;
  for (const auto& record : records)
    if (records.size() > 1) most = std::max(most, std::fabs(power({record}, quantity, top) / whole - 1.0));
  return most;
}

}  // namespace

ChannelNoise read_noise(const ChannelCodes& records, int quantity, double rate_Hz) {
  const Bands bands = telling_bands(records, quantity);
  ChannelNoise noise;
  if (!(bands.power[0] > 0.0)) {  // most codes do not change: a drive that is off, blows, a rig at rest
    const auto is_long = [&](const auto& record) { return record.size() >= bands.filter[0].size(); };
    if (std::any_of(records.begin(), records.end(), is_long)) noise.deviation = kRounding;
    return noise;
  }
  double white = bands.power[0] / gain(bands.filter[0], 0.0);
  const double pole = bands.pole(2);
  if (bands.white()) {
    noise.doubt = kWhiteDoubt;
  } else if (quantity == kDisplacement) {
    if (bands.fits(pole)) {
      noise.pole = pole, noise.doubt = kColouredDoubt;
    } else if (const FilteredNoise filtered = read_filtered_noise(records); filtered.variance > 0.0) {
      noise.correlation = filtered.correlation, noise.doubt = filtered.doubt;
      white = filtered.variance;
    }
  } else if (const double low = low_level(records, rate_Hz); low > 0.0) {
    if (low > kColouredLevel * white) noise.pole = pole_between(bands.filter[0], bands.power[0], low);
    white = std::min(white, low);
    noise.doubt = kLowDoubt;
  }
  noise.doubt = std::max(noise.doubt, spread(records, quantity, bands.filter[0], bands.power[0]));
  noise.deviation = std::sqrt(noise.pole == 0.0 ? white : bands.power[0] / gain(bands.filter[0], noise.pole));
  return noise;
}

bool hardly_noisy(const ChannelCodes& displacement) {
  constexpr double kLittle = 1e-5;
  double sum = 0, squares = 0, count = 0;
  for (const auto& record : displacement)
    for (const double code : record) sum += code, squares += code * code, ++count;
  const double variance = count > 0 ? squares / count - sum / count * (sum / count) : 0;
  const Taps top = band(kOrderOfDisplacement, 0);
  return power(displacement, kDisplacement, top) <= kLittle * kLittle * variance * gain(top, 0.0);
}

}  // namespace rig_file
