#include "host_sim/data_check/channel/slow_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "firmware/fixed_point/wider_vectors.hpp"
#include "host_sim/data_check/channel/harmonic.hpp"
#include "host_sim/data_check/channel/hum_weight.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr size_t kMostSamples = 1 << 16;  // of a spectrum at single frequencies
constexpr double kAboveSurroundings = 30.0;
constexpr double kLeastHum = 1e-4;  // of the channel: less bends no number
constexpr size_t kParts = 10;
constexpr double kSteady = 0.9, kDriftShare = 0.05;

// Amplitudes of a channel at a few frequencies, by a Hann window over its first samples (Goertzel, Amer. Math. Monthly
// 65, 1958). All frequencies go through the record side by side, so that the compiler can keep several in one register.
constexpr size_t kLine = 5, kAround = 16, kFrequencies = kLine + kAround;
FIRMWARE_WIDER_VECTORS void amplitudes_at(const std::vector<double>& windowed,
                                          const double (&cycles_per_sample)[kFrequencies],
                                          double (&amplitude)[kFrequencies]) {
  double twice_cosine[kFrequencies], last[kFrequencies] = {}, before[kFrequencies] = {};
  for (size_t k = 0; k < kFrequencies; ++k) twice_cosine[k] = 2.0 * std::cos(2.0 * kPi * cycles_per_sample[k]);
  for (const double value : windowed)
    for (size_t k = 0; k < kFrequencies; ++k) {
      const double next = value + twice_cosine[k] * last[k] - before[k];
      before[k] = last[k];
      last[k] = next;
    }
  for (size_t k = 0; k < kFrequencies; ++k)
    amplitude[k] = 4.0 * std::abs(last[k] - std::polar(1.0, -2.0 * kPi * cycles_per_sample[k]) * before[k]) /
                   static_cast<double>(windowed.size());
}

// The last one that was asked for is kept: all channels of a record are as long.
const std::vector<double>& hann_window(size_t count) {
  thread_local std::vector<double> window;
  if (window.size() == count) return window;
  window.resize(count);
  const std::complex<double> turn = std::polar(1.0, 2.0 * kPi / static_cast<double>(count));
  std::complex<double> at = 1.0;
  for (size_t i = 0; i < count; ++i, at *= turn) window[i] = 0.5 - 0.5 * at.real();
  return window;
}

// Without its mean, under a Hann window.
std::vector<double> windowed_start(const std::vector<double>& values, double mean) {
  std::vector<double> windowed(std::min(values.size(), kMostSamples));
  const std::vector<double>& window = hann_window(windowed.size());
  for (size_t i = 0; i < windowed.size(); ++i) windowed[i] = (values[i] - mean) * window[i];
  return windowed;
}

// What it does to the estimation is another number than what it is of the channel.
void weigh(const Record& record, const Channel& channel, double mains_Hz, int differentiated, Finding& hum) {
  if (is_drive(channel)) return;  // a force is taken as it is, and nothing is derived from it
  const double share = hum_share(record, channel, *hum.value, mains_Hz, differentiated);
  if (share < kHumSpoils) return;
  hum.weight = Weight::kDoubt;
  hum.detail += fmt::format(
      "; of what the estimation makes of this channel it has {:.2g} times the mean square of the motion: find where "
      "it comes from; diagnose takes it out, and so does a notch or a low-pass on all channels alike",
      share);
}

std::optional<Finding> find_hum(const Channel& channel, const Statistics& statistics,
                                const std::vector<double>& windowed, double sample_period_s, double mains_Hz) {
  const double resolution_Hz = 1.0 / (static_cast<double>(windowed.size()) * sample_period_s);
  if (resolution_Hz > 0.5 || mains_Hz + 5.0 > 0.45 / sample_period_s) return std::nullopt;
  double cycles[kFrequencies], amplitude[kFrequencies];
  for (size_t k = 0; k < kLine; ++k) cycles[k] = (mains_Hz + 0.05 * (static_cast<double>(k) - 2.0)) * sample_period_s;
  for (size_t k = 0; k < kAround; ++k) {
    const double off_Hz = std::max(1.0, 4.0 * resolution_Hz) + 0.37 * static_cast<double>(k / 2);
    cycles[kLine + k] = (mains_Hz + (k % 2 == 0 ? -off_Hz : off_Hz)) * sample_period_s;
  }
  amplitudes_at(windowed, cycles, amplitude);
  const double line = *std::max_element(amplitude, amplitude + kLine);
  double around = 0.0;
  for (size_t k = kLine; k < kFrequencies; ++k) around += amplitude[k] * amplitude[k];
  if (!(line * line > kAboveSurroundings * around / static_cast<double>(kAround)) || line < kLeastHum * statistics.rms)
    return std::nullopt;
  if (is_harmonic(channel, statistics.mean, sample_period_s, mains_Hz)) return std::nullopt;
  std::string text = fmt::format(
      "carries a line at {:.0f} Hz of amplitude {:.3g} ({:.2g} % of its rms): mains hum, if the excitation has no such "
      "line",
      mains_Hz, line, 100.0 * line / statistics.rms);
  return Finding{"hum", Weight::kInforms, channel.name, text, line};
}

std::optional<Finding> find_drift(const Channel& channel, const Statistics& statistics) {
  if (channel.quantity == Quantity::kForce || channel.values.size() < 40 * kParts || statistics.rms == 0.0)
    return std::nullopt;
  const size_t length = channel.values.size() / kParts;
  double means[kParts] = {};
  size_t crossings = 0;
  for (size_t part = 0; part < kParts; ++part) {
    for (size_t i = part * length; i < (part + 1) * length; ++i)
      means[part] += channel.values[i] / static_cast<double>(length);
    for (size_t i = part * length + 1; i < (part + 1) * length; ++i)
      if ((channel.values[i] > means[part]) != (channel.values[i - 1] > means[part])) ++crossings;
  }
  double mean = 0.0, moment = 0.0, square = 0.0, times = 0.0;
  for (const double part : means) mean += part / static_cast<double>(kParts);
  for (size_t part = 0; part < kParts; ++part) {
    const double t = static_cast<double>(part) - 0.5 * static_cast<double>(kParts - 1);
    moment += t * (means[part] - mean);
    square += (means[part] - mean) * (means[part] - mean);
    times += t * t;
  }
  if (!(square > 0.0) || crossings < 4 * kParts) return std::nullopt;
  const double correlation = moment / std::sqrt(square * times), over_record = moment / times * kParts;
  if (std::abs(correlation) < kSteady || std::abs(over_record) < kDriftShare * statistics.rms) return std::nullopt;
  std::string text = fmt::format("drifts by {:.3g} over the record ({:.2g} % of its rms)", over_record,
                                 100.0 * std::abs(over_record) / statistics.rms);
  return Finding{"drift", Weight::kInforms, channel.name, text, over_record};
}

}  // namespace

std::vector<Finding> find_slow_faults(const Record& record, const Channel& channel, const Statistics& statistics,
                                      int differentiated) {
  std::vector<Finding> findings;
  if (statistics.lowest == statistics.highest) return findings;
  const std::vector<double> windowed = windowed_start(channel.values, statistics.mean);
  for (const double mains_Hz : {50.0, 60.0})
    if (auto hum = find_hum(channel, statistics, windowed, record.sample_period_s, mains_Hz)) {
      weigh(record, channel, mains_Hz, differentiated, *hum);
      findings.push_back(std::move(*hum));
    }
  if (auto drift = find_drift(channel, statistics)) findings.push_back(std::move(*drift));
  return findings;
}

}  // namespace host_sim::data_check
