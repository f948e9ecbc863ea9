#include "host_sim/programs/results/advice.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hal/rig_file/channel_name.hpp"

namespace host_sim {
namespace {

void add_skew(const rig_file::RigModel& model, size_t dof_index, firmware::Quantity quantity,
              const firmware::SkewEstimate& skew, const std::vector<Record>& records,
              std::vector<SkewResult>& results) {
  if (!skew.measured) return;
  const rig_file::ChannelName channel{quantity, static_cast<int>(dof_index + 1), model.dofs[dof_index].rotating};
  const bool measured =
      records.empty() || records.front().find(static_cast<Quantity>(quantity), channel.dof) != nullptr;
  results.push_back({rig_file::format_channel_name(channel), rig_file::to_double(skew.late_s) * 1e6,
                     rig_file::to_double(skew.std_s) * 1e6, skew.significant, measured});
}

// What is made from other channels has no delay that a rig file could give.
std::string skew_advice(const std::vector<SkewResult>& skews, int dof) {
  for (const SkewResult& skew : skews)
    if (skew.significant && !skew.measured && rig_file::parse_channel_name(skew.channel)->dof == dof)
      return "measure " + skew.channel + " as well";
  return "give the late channel of DOF " + std::to_string(dof) + " its delay_us in the rig file";
}

// What is said of a number whose interval is wide beside it. Where it is a small one that is all: what it acts on may move well.
std::string raise_level(const firmware::Estimates& estimates, size_t index, const std::string& name) {
  if (index >= estimates.unknown_count || estimates.parameters[index].status == firmware::EstimateStatus::kNoExcitation)
    return "raise the level, or drive another DOF: what " + name + " acts on hardly moves, or noise hides which way";
  const firmware::ParameterEstimate& p = estimates.parameters[index];
  const double value = rig_file::to_double(p.value), low = rig_file::to_double(p.ci95_low),
               high = rig_file::to_double(p.ci95_high);
  const std::string known = low <= 0.0 && high >= 0.0
                                ? " may be nought: its 95 % interval holds it"
                                : fmt::format(" is known to {:.0f} % only", 50.0 * (high - low) / std::fabs(value));
  return name + known + "; where that matters, raise the level or drive another DOF";
}

}  // namespace

std::string advice_text(const rig_file::RigModel& model, const firmware::Estimates& estimates,
                        const std::vector<SkewResult>& skews, double level_ratio) {
  constexpr double kOtherLevel = 1.5;  // from here on two records are of two levels
  const std::vector<std::string> names = rig_file::parameter_names(model);
  const auto index = static_cast<size_t>(estimates.advice_index);
  const std::string name = index < names.size() ? names[index] : "the parameter";
  switch (estimates.advice) {
    case firmware::Advice::kNone:
      return "";
    case firmware::Advice::kAddFrequency:
      return "add a record excited near " + fmt::format("{:.3g}", rig_file::to_double(estimates.advice_frequency_Hz)) +
             " Hz as well";
    case firmware::Advice::kAddLevel:
      if (level_ratio < kOtherLevel) return "add a record of the same kind at another excitation level";
      return "add a record at a level that lies further off (these differ by a factor of " +
             fmt::format("{:.2g}", level_ratio) + "), of a wider band, or drive another DOF";
    case firmware::Advice::kRaiseLevel:
      return raise_level(estimates, index, name);
    case firmware::Advice::kLongerRecord:
      return "record longer: these data have too few windows to measure any scatter";
    case firmware::Advice::kLowerLevel:
      return "lower the level or widen the range of the sensor that is saturated";
    case firmware::Advice::kCompensateSkew:
      return skew_advice(skews, estimates.advice_index + 1);
  }
  return "";
}

std::string unresolved_text(const rig_file::RigModel& model, const firmware::Estimates& estimates) {
  constexpr double kWorthNaming = 0.2;
  const std::vector<std::string> names = rig_file::parameter_names(model);
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) {
    const double change = rig_file::to_double(estimates.unresolved[i]);
    if (!(std::abs(change) >= kWorthNaming)) continue;
    text += (text.empty() ? "" : ", ") + names[i] + fmt::format(" {:+.0f} %", 100.0 * change);
  }
  return text;
}

std::vector<SkewResult> skews_of(const rig_file::RigModel& model, const firmware::Estimates& estimates,
                                 const std::vector<Record>& records) {
  std::vector<SkewResult> results;
  for (size_t i = 0; i < model.dofs.size(); ++i) {
    add_skew(model, i, firmware::Quantity::kDisplacement, estimates.displacement_skew[i], records, results);
    add_skew(model, i, firmware::Quantity::kAcceleration, estimates.acceleration_skew[i], records, results);
  }
  return results;
}

std::string skew_note(const SkewResult& skew) {
  const std::string text =
      fmt::format("{} is {:.0f} us {} the velocity (+- {:.0f}): ", skew.channel, std::fabs(skew.late_us),
                  skew.late_us < 0.0 ? "ahead of" : "late against", 2.0 * skew.std_us);
  if (!skew.measured) return text + "it is made from other channels; measure it as well";
  return text + fmt::format("a [[channel]] with delay_us = {:.0f} in the rig file takes it away", skew.late_us);
}

}  // namespace host_sim
