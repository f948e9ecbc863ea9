#include "host_sim/data_check/channel/ripple.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "host_sim/data_check/measures/quantile.hpp"
#include "host_sim/data_check/measures/spectrum.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kFewestParts = 16, kLongestPart = 1024, kShortestPart = 128;  // samples of a part
constexpr double kAboveAround = 3.0;  // the mean of 16 spectra is that by chance in one of 3e7 bins
constexpr double kMotionShare = 0.99, kAboveMotion = 5.0;
constexpr double kLeastShare = 0.01, kMostShare = 0.2;  // of the force's power
constexpr size_t kLine = 3, kAround = 24, kBelow = 8;   // bins to each side

double sum_of(const std::vector<double>& power, size_t from, size_t to) {
  return std::accumulate(power.begin() + static_cast<std::ptrdiff_t>(from),
                         power.begin() + static_cast<std::ptrdiff_t>(to), 0.0);
}

double mean_of(const double* from, size_t n) { return std::accumulate(from, from + n, 0.0) / static_cast<double>(n); }

// Below it lies nearly all power of a motion channel.
double band_Hz(const std::vector<double>& values, double sample_period_s) {
  const size_t n = quick_length(values.size());
  const std::vector<double> power = power_spectrum(values.data(), n, mean_of(values.data(), n));
  const double total = sum_of(power, 1, power.size());
  double held = 0.0;
  size_t bin = 1;
  while (bin + 1 < power.size() && (held += power[bin]) < kMotionShare * total) ++bin;
  return static_cast<double>(bin) / (static_cast<double>(n) * sample_period_s);
}

std::vector<double> mean_spectrum(const std::vector<double>& values, size_t part) {
  std::vector<double> mean(part / 2 + 1, 0.0);
  for (size_t from = 0; from + part <= values.size(); from += part) {
    const std::vector<double> power = power_spectrum(values.data() + from, part, mean_of(values.data() + from, part));
    for (size_t i = 0; i < mean.size(); ++i) mean[i] += power[i];
  }
  return mean;
}

// Median of the bins beside one and its neighbours; or of the nearest below it, where that is more: a spectrum that falls (friction's,
// whose sign jumps) stands above what follows everywhere, and is no line.
double around(const std::vector<double>& power, size_t bin) {
  std::vector<double> beside, below;
  for (size_t k = bin > kAround ? bin - kAround : 1; k < std::min(power.size(), bin + kAround + 1); ++k) {
    if (k + kLine < bin || k > bin + kLine) beside.push_back(power[k]);
    if (k + kLine < bin && k + kLine + kBelow >= bin) below.push_back(power[k]);
  }
  return std::max(quantile(beside, 0.5), below.empty() ? 0.0 : quantile(below, 0.5));
}

// Whether a bin stands so far above half of those beside it. Counted, as no more is asked of nearly all bins.
bool above_half(const std::vector<double>& power, size_t bin) {
  size_t beside = 0, lower = 0;
  for (size_t k = bin > kAround ? bin - kAround : 1; k < std::min(power.size(), bin + kAround + 1); ++k) {
    const bool is_beside = (k + kLine < bin) | (k > bin + kLine);
    beside += is_beside ? 1 : 0;
    lower += is_beside & (kAboveAround * power[k] < power[bin]) ? 1 : 0;
  }
  return lower > (beside - 1) / 2;
}

// Bins that stand far above those around them.
struct Line {
  size_t bin = 0;
  double level = 0.0;  // of those around it
};
std::vector<Line> lines_of(const std::vector<double>& power) {
  std::vector<Line> lines;
  for (size_t bin = 2 * kLine; bin + kLine + 1 < power.size(); ++bin) {
    if (!above_half(power, bin)) continue;
    const double level = around(power, bin);
    if (level > 0.0 && power[bin] > kAboveAround * level) lines.push_back({bin, level});
  }
  return lines;
}

bool acts_on_mass(const Channel& force, const rig_file::RigModel& model) {
  if (force.dof < 1 || static_cast<size_t>(force.dof) > model.dofs.size()) return false;
  const rig_file::Coefficient& mass = model.dofs[static_cast<size_t>(force.dof - 1)].mass_kg;
  return mass.estimate || mass.value > 0.0;
}

}  // namespace

std::optional<Finding> find_ripple(const Record& record, const Channel& force, const rig_file::RigModel& model) {
  if (force.quantity != Quantity::kForce || !acts_on_mass(force, model)) return std::nullopt;
  size_t part = kLongestPart;
  while (part >= kShortestPart && force.values.size() < kFewestParts * part) part /= 2;
  if (part < kShortestPart) return std::nullopt;
  const std::vector<double> power = mean_spectrum(force.values, part);
  const double bin_Hz = 1.0 / (static_cast<double>(part) * record.sample_period_s);
  const std::vector<Line> lines = lines_of(power);
  if (lines.empty()) return std::nullopt;  // nearly always: the motion need not be looked at
  double motion_Hz = 0.0;
  for (const Channel& channel : record.channels)
    if (channel.quantity != Quantity::kForce)
      motion_Hz = std::max(motion_Hz, band_Hz(channel.values, record.sample_period_s));
  size_t best = 0;
  double above = kAboveAround;
  for (const Line& at : lines)
    if (static_cast<double>(at.bin) >= std::ceil(kAboveMotion * motion_Hz / bin_Hz) && power[at.bin] > above * at.level)
      best = at.bin, above = power[at.bin] / at.level;
  if (best == 0) return std::nullopt;
  const double line =
      sum_of(power, best - kLine, best + kLine + 1) - static_cast<double>(2 * kLine + 1) * around(power, best);
  const double share = line / sum_of(power, 1, power.size());
  if (share < kLeastShare || share > kMostShare) return std::nullopt;
  const double hertz = static_cast<double>(best) * bin_Hz;
  return Finding{"ripple", Weight::kInforms, force.name,
                 fmt::format("carries a ripple near {:.0f} Hz of amplitude {:.2g} ({:.2g} % of its power), far above "
                             "all motion: of the drive or of its sensor, if the excitation has no such line",
                             hertz, std::sqrt(2.0 * share) * mean_and_rms(force.values).rms, 100.0 * share),
                 hertz};
}

std::vector<std::string> ripples_of(const Report& report) {
  std::map<std::string, std::pair<double, double>> ranges_Hz;
  for (const RecordReport& record : report.records)
    for (const ChannelReport& channel : record.channels)
      for (const Finding& finding : channel.findings)
        if (finding.kind == "ripple" && finding.value) {
          auto& [low, high] = ranges_Hz.try_emplace(channel.name, *finding.value, *finding.value).first->second;
          low = std::min(low, *finding.value), high = std::max(high, *finding.value);
        }
  std::vector<std::string> told;
  for (const auto& [name, range] : ranges_Hz)
    told.push_back(fmt::format(
        "{} carries a ripple near {:.0f}{} Hz that the motion does not show: it counts as noise "
        "of that channel (host_sim check tells its size)",
        name, range.first, range.second > range.first + 0.5 ? fmt::format(" to {:.0f}", range.second) : ""));
  return told;
}

}  // namespace host_sim::data_check
