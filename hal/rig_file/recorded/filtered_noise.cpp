#include "hal/rig_file/recorded/filtered_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rig_file {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kLength = 256,
              kBins = kLength / 2 + 1;  // of a segment; resolves a twentieth of the sample rate thirteen times
constexpr int kLags = 64;               // a filter of fourth order has forgotten after 20
// Bands of a third of an octave from a twentieth of the sample rate on: 10 of them, the last from 0.4.
constexpr int kBands = 10;
constexpr double kLowest = 0.05, kStep = 1.26;
// Bands of six bins and 50 segments scatter by 6 %. A motion that still falls does so by a factor of 2 and more from one to the next.
constexpr double kLevel = 1.4;
// A filter that leaves more at the top is no anti-alias filter; coloured noise of first order up to a pole of 0.8 leaves more.
constexpr double kCliff = 0.01;
// Behind a filter the spectrum falls to its very end. Beside a motion that fills the band up to the same place noise ends the fall.
constexpr double kFall = 3.0;
constexpr double kMostShare = 0.01;  // of the channel's mean square: 10 % of its rms. More is motion
constexpr double kLeastDoubt = 0.1;

// Mean power of segments that overlap by half, under Blackman and Harris' window: a motion stands 60 dB above the noise, and what it
// leaves beyond four bins is 92 dB down.
std::vector<double> spectrum(const ChannelCodes& records) {
  std::vector<double> power(kBins, 0.0), window(kLength), turn(kLength);
  double segments = 0, window_power = 0;
  for (int n = 0; n < kLength; ++n) {
    const double phase = 2 * kPi * (n + 0.5) / kLength;
    window[n] = 0.35875 - 0.48829 * std::cos(phase) + 0.14128 * std::cos(2 * phase) - 0.01168 * std::cos(3 * phase);
    window_power += window[n] * window[n];
    turn[n] = std::cos(2 * kPi * n / kLength);
  }
  std::vector<double> turns, quarters;  // of all bins, one sample after the other
  for (int n = 0; n < kLength; ++n)
    for (int k = 0; k < kBins; ++k)
      turns.push_back(turn[k * n % kLength]), quarters.push_back(turn[(k * n + kLength / 4) % kLength]);
  std::vector<double> cosine(kBins), sine(kBins);
  for (const auto& record : records)
    for (size_t from = 0; from + kLength <= record.size(); from += kLength / 2, ++segments) {
      double mean = 0;
      for (int n = 0; n < kLength; ++n) mean += record[from + n] / double{kLength};
      std::fill(cosine.begin(), cosine.end(), 0.0), std::fill(sine.begin(), sine.end(), 0.0);
      for (int n = 0; n < kLength; ++n) {
        const double value = window[n] * (record[from + n] - mean);
        const double *const of_cosine = turns.data() + n * kBins, *const of_sine = quarters.data() + n * kBins;
        for (int k = 0; k < kBins; ++k) cosine[k] += value * of_cosine[k], sine[k] += value * of_sine[k];
      }
      for (int k = 0; k < kBins; ++k) power[k] += cosine[k] * cosine[k] + sine[k] * sine[k];
    }
  for (double& p : power) p /= std::max(segments, 1.0) * window_power;
  return power;
}

int first_bin(int band) { return static_cast<int>(std::lround(kLowest * std::pow(kStep, band) * kLength)); }

double band_power(const std::vector<double>& power, int band) {
  const int from = first_bin(band), to = std::min(first_bin(band + 1), kBins);
  double sum = 0;
  for (int k = from; k < to; ++k) sum += power[k];
  return sum / (to - from);
}

}  // namespace

FilteredNoise read_filtered_noise(const ChannelCodes& records) {
  FilteredNoise noise;
  std::vector<double> power = spectrum(records);
  const double top = band_power(power, kBands - 1);
  int band = 0;
  double ratio = 0;
  for (; band + 2 < kBands; ++band) {
    ratio = band_power(power, band) / band_power(power, band + 1);
    if (ratio < kLevel && ratio > 1 / kLevel) break;
  }
  if (band + 2 >= kBands) return noise;
  const double level = 0.5 * (band_power(power, band) + band_power(power, band + 1));
  if (!(top < kCliff * level) || band_power(power, kBands - 2) < kFall * top) return noise;
  const double whole = std::accumulate(power.begin(), power.end(), 0.0);
  std::fill(power.begin(), power.begin() + first_bin(band + 1), level);
  if (std::accumulate(power.begin(), power.end(), 0.0) > kMostShare * whole) return noise;
  noise.doubt = std::max(kLeastDoubt, std::fabs(ratio - 1));
  for (int lag = 0; lag < kLags; ++lag) {
    double sum = 0;
    for (int k = 0; k < kBins; ++k)
      sum += (k == 0 || k == kBins - 1 ? 0.5 : 1.0) * power[k] * std::cos(2 * kPi * k * lag / kLength);
    noise.correlation.push_back(2 * sum / kLength);
  }
  noise.variance = noise.correlation[0];
  for (double& r : noise.correlation) r /= noise.variance;
  return noise;
}

}  // namespace rig_file
