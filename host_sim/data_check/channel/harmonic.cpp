#include "host_sim/data_check/channel/harmonic.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/measures/spectrum.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kMostSamples = 1 << 16;
constexpr double kPlace = 0.2;  // bins: how well a peak is placed by its bins under a Hann window, beside what dies out
constexpr double kBeside = 1.0 / 3.0;  // of a line: odd harmonics of dry friction fall more slowly than that

// What a tone in bin `at` (a broken number) has, from the powers around it: a Hann window spreads it over four bins.
double amplitude_in(const std::vector<double>& power, double at) {
  const auto middle = static_cast<size_t>(std::lround(at));
  if (middle < 2 || middle + 2 >= power.size()) return 0.0;
  double sum = 0.0;
  for (size_t i = middle - 2; i <= middle + 2; ++i) sum += power[i];
  return std::sqrt(sum);
}

}  // namespace

bool is_harmonic(const Channel& channel, double mean, double sample_period_s, double line_Hz) {
  const size_t length = quick_length(std::min(channel.values.size(), kMostSamples));
  const std::vector<double> power = power_spectrum(channel.values.data(), length, mean);
  const auto peak = static_cast<size_t>(std::max_element(power.begin() + 1, power.end()) - power.begin());
  if (peak < 3 || peak + 2 >= power.size()) return false;
  double moment = 0.0, sum = 0.0;
  for (size_t i = peak - 2; i <= peak + 2; ++i) moment += power[i] * static_cast<double>(i), sum += power[i];
  const double tone = moment / sum, line = line_Hz * static_cast<double>(length) * sample_period_s;
  const double order = std::round(line / tone);
  if (order < 2.0 || std::abs(line - order * tone) > kPlace * order + 1.0) return false;
  const double own = amplitude_in(power, line);
  for (const double beside : {-2.0, -1.0, 1.0, 2.0})
    if (order + beside > 1.0 && amplitude_in(power, line + beside * tone) > kBeside * own) return true;
  return false;
}

}  // namespace host_sim::data_check
