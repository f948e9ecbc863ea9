#include "host_sim/data_check/drive/excitation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/measures/spectrum.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kMostLines = 5;
constexpr double kLineShare = 0.9;

// Takes the strongest lines off until 90 % of the power is gone; empty where more than five are needed.
std::vector<double> lines_of(std::vector<double> power, double bin_Hz) {
  double total = 0.0;
  for (const double p : power) total += p;
  std::vector<double> lines;
  double held = 0.0;
  while (lines.size() < kMostLines) {
    const auto peak = static_cast<size_t>(std::max_element(power.begin(), power.end()) - power.begin());
    double moment = 0.0, line = 0.0;
    for (size_t i = peak > 3 ? peak - 3 : 0; i < std::min(power.size(), peak + 4); ++i) {
      line += power[i];
      moment += power[i] * static_cast<double>(i);
      power[i] = 0.0;
    }
    if (line > 0.02 * total) lines.push_back(moment / line * bin_Hz);
    held += line;
    if (held >= kLineShare * total) {
      std::sort(lines.begin(), lines.end());
      return lines;
    }
    if (line <= 0.02 * total) return {};
  }
  return {};
}

std::string quantity_unit(const std::string& channel) {
  const size_t second = channel.find('_', channel.find_first_of("0123456789b"));
  std::string unit = second == std::string::npos ? "" : channel.substr(second + 1);
  std::replace(unit.begin(), unit.end(), '_', unit.rfind("N_m", 0) == 0 ? ' ' : '/');
  return unit;
}

std::string text_of(const Drive& drive) {
  if (drive.channel.empty()) return "no force and no base is recorded: taken as a free decay";
  if (drive.constant != 0.0)
    return fmt::format("{}: a constant {:.4g} {}", drive.channel, drive.constant, quantity_unit(drive.channel));
  const std::string level = fmt::format("{}: {:.4g} {} rms, ", drive.channel, drive.rms, quantity_unit(drive.channel));
  if (drive.lines_Hz.empty())
    return level + fmt::format("{:.3g} to {:.3g} Hz (90 % of its power)", drive.from_Hz, drive.to_Hz);
  std::string tones;
  for (const double line : drive.lines_Hz) tones += fmt::format("{}{:.4g}", tones.empty() ? "" : ", ", line);
  return level + (drive.lines_Hz.size() == 1 ? "tone at " : "tones at ") + tones + " Hz";
}

}  // namespace

namespace {

// Of a command that never changes; without a channel where there is none.
Drive constant_drive(const Record& record) {
  Drive drive;
  for (const Channel& channel : record.channels)
    if (drives(channel) && std::abs(channel.values.front()) > std::abs(drive.constant))
      drive.channel = channel.name, drive.constant = channel.values.front();
  return drive;
}

}  // namespace

Drive drive_of(const Record& record) {
  const Channel* strongest = nullptr;
  double largest = 0.0, mean = 0.0;
  for (const bool forces : {true, false})
    for (const Channel& channel : record.channels) {
      if (strongest != nullptr && !forces && strongest->quantity == Quantity::kForce) break;
      if (forces ? channel.quantity != Quantity::kForce : channel.dof != rig_file::kBase) continue;
      const MeanAndRms of = mean_and_rms(channel.values);
      if (!(of.rms > largest)) continue;
      largest = of.rms;
      mean = of.mean;
      strongest = &channel;
    }
  Drive drive;
  if (strongest == nullptr) return constant_drive(record);
  if (strongest->values.size() < 64) return drive;
  drive.channel = strongest->name;
  drive.rms = largest;
  const size_t length = quick_length(strongest->values.size());
  const std::vector<double> power = power_spectrum(strongest->values.data(), length, mean);
  const double bin_Hz = 1.0 / (static_cast<double>(length) * record.sample_period_s);
  drive.lines_Hz = lines_of(power, bin_Hz);
  double total = 0.0, sum = 0.0;
  for (const double p : power) total += p;
  for (size_t i = 0; i < power.size(); ++i) {
    if (sum < 0.05 * total) drive.from_Hz = static_cast<double>(i) * bin_Hz;
    if (sum < 0.95 * total) drive.to_Hz = static_cast<double>(i) * bin_Hz;
    sum += power[i];
  }
  return drive;
}

std::vector<Finding> describe_excitation(const std::vector<Record>& records, const std::vector<Drive>& drives) {
  std::vector<Finding> findings;
  for (size_t r = 0; r < records.size(); ++r)
    findings.push_back(
        {"excitation", Weight::kInforms, "", records[r].file + ": " + text_of(drives[r]), drives[r].rms});
  double low = 0.0, high = 0.0, tone = 0.0;
  bool one_tone = true;
  for (const Drive& drive : drives) {
    if (drive.channel.empty()) return findings;  // a decay passes through all levels
    low = low == 0.0 ? drive.rms : std::min(low, drive.rms);
    high = std::max(high, drive.rms);
    one_tone = one_tone && drive.lines_Hz.size() == 1;
    if (!one_tone) continue;
    if (tone != 0.0 && std::abs(drive.lines_Hz[0] / tone - 1.0) > 0.02) one_tone = false;
    tone = drive.lines_Hz[0];
  }
  if (one_tone && high < 1.5 * low)
    findings.push_back(
        {"excitation", Weight::kInforms, "",
         "one tone at one level: viscous and Coulomb friction look alike, and mass, stiffness and several "
         "dampers cannot be told apart; add a level (a factor of 2) and a frequency or a random band",
         std::nullopt});
  return findings;
}

}  // namespace host_sim::data_check
