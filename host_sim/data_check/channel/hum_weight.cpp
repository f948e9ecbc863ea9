#include "host_sim/data_check/channel/hum_weight.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "host_sim/data_check/measures/spectrum.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kTwoPi = 6.28318530717958647693;
constexpr size_t kMostSamples = 1 << 16;
constexpr double kAboveNoise = 30.0;
constexpr double kBeside_Hz = 2.0;
constexpr double kDriven = 0.1;  // of the line's share of its channel
constexpr double kHann = 3.0 / 8.0;

// Mean squares by frequency; the Hann window's own is taken off.
struct Lines {
  std::vector<double> mean_square;
  double bin_Hz = 0.0;
};

Lines lines_of(const Channel& channel, double mean, double sample_period_s) {
  const size_t length = quick_length(std::min(channel.values.size(), kMostSamples));
  const auto n = static_cast<double>(length);
  Lines lines{power_spectrum(channel.values.data(), length, mean), 1.0 / (n * sample_period_s)};
  for (double& power : lines.mean_square) power *= 2.0 / (n * n * kHann);
  return lines;
}

bool is_beside(double at_Hz, double line_Hz) { return std::abs(at_Hz - line_Hz) < kBeside_Hz; }

// Of the line, over the channel's whole: bins around it.
double share_of_line(const Channel& channel, double line_Hz, double sample_period_s) {
  const MeanAndRms of = mean_and_rms(channel.values);
  if (!(of.rms > 0.0)) return 0.0;
  const Lines lines = lines_of(channel, of.mean, sample_period_s);
  double line = 0.0;
  for (size_t i = 0; i < lines.mean_square.size(); ++i)
    if (std::abs(static_cast<double>(i) * lines.bin_Hz - line_Hz) < 3.0 * lines.bin_Hz) line += lines.mean_square[i];
  return std::sqrt(line) / of.rms;
}

}  // namespace

double hum_share(const Record& record, const Channel& channel, double line_amplitude, double line_Hz,
                 int differentiated) {
  const MeanAndRms of = mean_and_rms(channel.values);
  const double share = line_amplitude / std::sqrt(2.0) / of.rms;
  for (const Channel& drive : record.channels)
    if (is_drive(drive) && share_of_line(drive, line_Hz, record.sample_period_s) > kDriven * share) return 0.0;
  const Lines lines = lines_of(channel, of.mean, record.sample_period_s);
  const double noise = kAboveNoise * median_power(lines.mean_square, 0, lines.mean_square.size());
  const auto as_estimated = [&](double mean_square, double at_Hz) {
    return mean_square * std::pow(kTwoPi * at_Hz, 2.0 * differentiated);
  };
  double motion = 0.0;
  for (size_t i = 1; i < lines.mean_square.size(); ++i) {
    const double at_Hz = static_cast<double>(i) * lines.bin_Hz;
    if (lines.mean_square[i] > noise && !is_beside(at_Hz, line_Hz)) motion += as_estimated(lines.mean_square[i], at_Hz);
  }
  return motion > 0.0 ? as_estimated(0.5 * line_amplitude * line_amplitude, line_Hz) / motion : 0.0;
}

std::string spoilt_by_hum(const Report& report) {
  std::set<std::string> names;
  for (const RecordReport& record : report.records)
    for (const ChannelReport& channel : record.channels)
      for (const Finding& finding : channel.findings)
        if (finding.kind == "hum" && finding.weight != Weight::kInforms) names.insert(channel.name);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace host_sim::data_check
