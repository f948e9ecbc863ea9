#include "host_sim/programs/estimate/channel_correction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "hal/rig_file/channel_entry.hpp"
#include "hal/rig_file/channel_name.hpp"

namespace host_sim {
namespace {

constexpr double kWellMeasured = 8.0;  // standard deviations
constexpr std::string_view kOfChannel = "channel ";
constexpr double kMostPeriods = 3.0;
constexpr double kMostGain = 0.2;
constexpr double kRivalLeaves = 5.5;  // deviations: no chance among a hundred forces

// The delays of one DOF's displacement and acceleration against its velocity.
struct OfDof {
  const SkewResult* displacement = nullptr;
  const SkewResult* acceleration = nullptr;
};

std::optional<ChannelCorrection> choose(const OfDof& dof) {
  const SkewResult* x = dof.displacement;
  const SkewResult* a = dof.acceleration;
  if (x != nullptr && a != nullptr) {
    const double difference = std::fabs(x->late_us - a->late_us), noise = std::hypot(x->std_us, a->std_us);
    if (difference > 4.0 * noise && difference > 0.1 * std::fabs(x->late_us)) return std::nullopt;  // all three differ
    rig_file::ChannelName name = *rig_file::parse_channel_name(x->channel);
    name.quantity = firmware::Quantity::kVelocity;
    ChannelCorrection early;
    early.channel = rig_file::format_channel_name(name);
    early.late_us = -x->late_us;
    early.std = x->std_us;
    return early;
  }
  const SkewResult* one = x != nullptr ? x : a;
  ChannelCorrection late;
  late.channel = one->channel;
  late.late_us = one->late_us;
  late.std = one->std_us;
  return late;
}

// What the board names, where it is one channel's and nothing else can stand in its place.
std::optional<ChannelCorrection> of_warrant(const WarrantResult& warrant, const std::vector<Record>& records) {
  const FindingResult& named = warrant.named;
  const bool gain = named.effect == "sensor_gain";
  if (!gain && named.effect != "sensor_delay") return std::nullopt;
  const auto name = rig_file::parse_channel_name(named.where.substr(kOfChannel.size()));
  if (!name || name->dof == rig_file::kBase) return std::nullopt;
  const bool of_force = name->quantity == firmware::Quantity::kForce;
  if (!gain && !of_force) return std::nullopt;  // delays of the motion's channels are the skews
  // A velocity that is made of displacement and acceleration measures no gain of either: channel_pairs.hpp.
  if (!of_force && records.front().find(Quantity::kVelocity, name->dof) == nullptr) return std::nullopt;
  const double deviations = std::fabs(named.size) / named.std;
  if (!(deviations > kWellMeasured)) return std::nullopt;
  if (std::fabs(named.size) > (gain ? kMostGain : kMostPeriods * records.front().sample_period_s)) return std::nullopt;
  ChannelCorrection correction;
  correction.channel = named.where.substr(kOfChannel.size());
  correction.by_channels = !of_force;
  (gain ? correction.gain : correction.late_us) = named.size * (gain ? 1.0 : 1e6);
  correction.std = named.std * (gain ? 1.0 : 1e6);
  const double rival_leaves = std::sqrt(std::max(0.0, 1.0 - warrant.rival_percent / 100.0)) * deviations;
  if (!correction.by_channels && rival_leaves < kRivalLeaves) return std::nullopt;
  return correction;
}

bool only_force(const std::string& channel, const Record& record) {
  return std::all_of(record.channels.begin(), record.channels.end(),
                     [&](const Channel& other) { return other.quantity != Quantity::kForce || other.name == channel; });
}

// By an error of the scale of all masses and springs that may be as large as the force's gain: a rectangular distribution of that half
// width (GUM, JCGM 100:2008, 4.3.7), of which twice the standard deviation is in the 95 % interval.
void widen(double gain, EstimateResult& result) {
  std::vector<double> doubt;
  for (ParameterResult& p : result.parameters) {
    doubt.push_back(std::fabs(gain * p.value) / std::sqrt(3.0));
    if (p.std == 0.0) continue;  // nothing is known of it
    p.std = std::hypot(p.std, doubt.back());
    p.ci95_low -= 2.0 * doubt.back(), p.ci95_high += 2.0 * doubt.back();
  }
  for (size_t i = 0; i < result.covariance.size(); ++i)
    for (size_t j = 0; j < result.covariance.size(); ++j)
      result.covariance[i][j] +=
          std::copysign(doubt[i] * doubt[j], result.parameters[i].value * result.parameters[j].value);
}

}  // namespace

std::vector<ChannelCorrection> delays_to_correct(const std::vector<SkewResult>& skews,
                                                 const std::vector<Record>& records) {
  std::map<int, OfDof> dofs;
  for (const SkewResult& skew : skews) {
    const auto name = rig_file::parse_channel_name(skew.channel);
    if (!skew.significant || !name) continue;
    // A velocity that is made of displacement and acceleration is no witness against either.
    if (records.front().find(Quantity::kVelocity, name->dof) == nullptr) continue;
    OfDof& dof = dofs[name->dof];
    (name->quantity == firmware::Quantity::kDisplacement ? dof.displacement : dof.acceleration) = &skew;
  }
  std::vector<ChannelCorrection> corrections;
  for (const auto& [number, dof] : dofs) {
    const std::optional<ChannelCorrection> correction = choose(dof);
    if (!correction || std::fabs(correction->late_us) < kWellMeasured * correction->std) continue;
    if (std::fabs(correction->late_us) * 1e-6 > kMostPeriods * records.front().sample_period_s) continue;
    corrections.push_back(*correction);
  }
  return corrections;
}

std::vector<ChannelCorrection> corrections_to_make(const EstimateResult& result, const std::vector<Record>& records,
                                                   bool first) {
  if (result.warrant.named.effect == "force_hold") return {};  // what looks late there is the force's steps
  std::vector<ChannelCorrection> corrections = delays_to_correct(result.skews, records);
  if (!corrections.empty()) return corrections;
  const auto named = of_warrant(result.warrant, records);
  if (named && (first || named->by_channels)) corrections.push_back(*named);
  return corrections;
}

void add_corrections(const std::vector<ChannelCorrection>& more, std::vector<ChannelCorrection>& corrections) {
  for (const ChannelCorrection& one : more) {
    const auto known = std::find_if(corrections.begin(), corrections.end(), [&](const ChannelCorrection& other) {
      return other.channel == one.channel && (other.gain != 0.0) == (one.gain != 0.0);
    });
    if (known == corrections.end()) {
      corrections.push_back(one);
      continue;
    }
    known->late_us += one.late_us;
    known->gain = (1.0 + known->gain) * (1.0 + one.gain) - 1.0;
    known->std = one.std;
  }
}

rig_file::RigModel with_delays(const rig_file::RigModel& model, const std::vector<ChannelCorrection>& corrections) {
  rig_file::RigModel result = model;
  for (const ChannelCorrection& correction : corrections)
    if (correction.late_us != 0.0) rig_file::entry_to_write(result, correction.channel).delay_us += correction.late_us;
  return result;
}

bool any_gain(const std::vector<ChannelCorrection>& corrections) {
  return std::any_of(corrections.begin(), corrections.end(), [](const auto& c) { return c.gain != 0.0; });
}

std::vector<Record> without_gains(const std::vector<ChannelCorrection>& corrections,
                                  const std::vector<Record>& records) {
  std::vector<Record> result = records;
  for (const ChannelCorrection& correction : corrections)
    for (Record& record : result)
      for (Channel& channel : record.channels)
        if (correction.gain != 0.0 && channel.name == correction.channel)
          for (double& value : channel.values) value /= 1.0 + correction.gain;
  return result;
}

bool corrections_hold(const EstimateResult& corrected, const std::vector<ChannelCorrection>& corrections,
                      const std::vector<Record>& records) {
  if (!corrections_to_make(corrected, records, false).empty()) return false;
  return corrected.warrant.named.effect.empty() ||
         std::all_of(corrections.begin(), corrections.end(), [](const auto& c) { return c.by_channels; });
}

void tell_corrections(const std::vector<ChannelCorrection>& corrections, const std::vector<Record>& records,
                      EstimateResult& corrected) {
  WarrantResult& warrant = corrected.warrant;
  for (const ChannelCorrection& c : corrections) {
    const bool gain = c.gain != 0.0, scale = gain && !c.by_channels && only_force(c.channel, records.front());
    corrected.notes.push_back(
        correction_note(c) + (scale ? fmt::format("; were it right, every mass, spring and coefficient would be {:.4g} "
                                                  "times as large: the intervals hold both",
                                                  1.0 + c.gain)
                                    : ""));
    if (scale) widen(c.gain, corrected);
    warrant.corrected.push_back({gain ? "sensor_gain" : "sensor_delay", std::string(kOfChannel) + c.channel,
                                 gain ? c.gain : c.late_us * 1e-6, gain ? c.std : c.std * 1e-6, gain ? "" : "s"});
  }
  warrant.explained = warrant.named.effect.empty();
  if (warrant.explained) warrant.named = warrant.corrected.front();
}

std::string correction_note(const ChannelCorrection& c) {
  const char* const against = c.by_channels ? "the other channels of its DOF" : "the rig's equations of motion";
  if (c.gain != 0.0)
    return fmt::format("{} said {:.4g} times what it should by {} (+- {:.2g}): corrected", c.channel, 1.0 + c.gain,
                       against, 2.0 * c.std);
  return fmt::format("{} was {:.0f} us {} against {} (+- {:.1f}): corrected", c.channel, std::fabs(c.late_us),
                     c.late_us > 0 ? "late" : "early", against, 2.0 * c.std);
}

}  // namespace host_sim
