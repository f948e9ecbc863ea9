#include "host_sim/data_check/time_base/time_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "host_sim/response/modes.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kSame = 0.02;                          // of a factor and its square
constexpr double kYear2000 = 36526, kYear2100 = 73050;  // day numbers
constexpr double kShortestStep_s = 1e-5;                // of rigs: a day number's is 1e-8 at a kilohertz

std::string unit_of(double factor) {
  for (const auto& [size, word] : {std::pair{1e3, "ms"}, {1e6, "us"}, {1e-3, "ks"}, {1.0 / 60, "minutes"}})
    if (std::abs(factor / size - 1) < kSame) return fmt::format("the times are in {}: ", word);
  return fmt::format("the times are {:.4g} times too long: ", factor);
}

// The file may be right and what the user says of it wrong.
std::string told_by_user(double factor, const Record& record) {
  const double rate_Hz = 1.0 / record.sample_period_s;
  return fmt::format("--sample-rate {:.4g} does not go with the motion, {:.4g} would: ", rate_Hz, factor * rate_Hz);
}

const char* remedy(TimesFrom from) {
  switch (from) {
    case TimesFrom::kColumn:
      return "; name the unit in the head of the time's column";
    case TimesFrom::kFile:
      return "; tell the true rate with --sample-rate";
    case TimesFrom::kUser:
      return "";
  }
  return "";
}

// The factor by which a channel of that quantity of the DOF is said to be too large.
std::optional<double> too_large(const Record& record, const RecordReport& report, Quantity quantity, int dof) {
  const Channel* const channel = record.find(quantity, dof);
  for (const ChannelReport& c : report.channels)
    for (const Finding& f : c.findings)
      if (channel != nullptr && c.name == channel->name && f.kind == "unit" && f.value) return *f.value;
  return {};
}

void forget_units(const Record& record, int dof, RecordReport& report) {
  for (ChannelReport& c : report.channels) {
    const auto is_of = [&](const Channel& channel) { return channel.name == c.name && channel.dof == dof; };
    if (std::none_of(record.channels.begin(), record.channels.end(), is_of)) continue;
    c.findings.erase(
        std::remove_if(c.findings.begin(), c.findings.end(), [](const Finding& f) { return f.kind == "unit"; }),
        c.findings.end());
  }
}

// Two channels of one DOF cannot tell a velocity in mm/s from times in ms: both are said.
void name_the_times_too(const Record& record, RecordReport& report) {
  const auto others = [&](const Channel& channel) {
    std::vector<const Channel*> list;
    for (const Channel& c : record.channels)
      if (c.dof == channel.dof && c.quantity != Quantity::kForce && &c != &channel) list.push_back(&c);
    return list;
  };
  for (size_t i = 0; i < record.channels.size(); ++i)
    for (Finding& finding : report.channels[i].findings) {
      const std::vector<const Channel*> beside = others(record.channels[i]);
      if (finding.kind != "unit" || !finding.value || beside.size() != 1) continue;
      const int order = static_cast<int>(record.channels[i].quantity) - static_cast<int>(beside[0]->quantity);
      for (const auto& [size, word] : {std::pair{1e3, "ms"}, {1e6, "us"}})
        if (order > 0 && std::abs(*finding.value / std::pow(size, order) - 1) < kSame)
          finding.detail += fmt::format("; or the times are in {} (--unit t={})", word, word);
    }
}

Finding told(const std::string& text, Weight weight = Weight::kFault) {
  return {"unit", weight, "t_s", text, std::nullopt};
}

}  // namespace

void find_time_unit(const Record& record, const rig_file::RigModel* model, RecordReport& report) {
  if (record.start_s > kYear2000 && record.start_s < kYear2100 && record.sample_period_s < kShortestStep_s) {
    for (const Channel& channel : record.channels) forget_units(record, channel.dof, report);
    report.findings.push_back(told("the times are days, as a spreadsheet counts them: give seconds, or --sample-rate"));
    return;
  }
  std::optional<double> factor;
  for (const Channel& channel : record.channels) {
    if (channel.quantity != Quantity::kDisplacement) continue;
    const auto velocity = too_large(record, report, Quantity::kVelocity, channel.dof),
               acceleration = too_large(record, report, Quantity::kAcceleration, channel.dof);
    if (!velocity || !acceleration || std::abs(*acceleration / (*velocity * *velocity) - 1) > kSame) continue;
    factor = velocity;
    forget_units(record, channel.dof, report);
  }
  if (factor) {
    const TimesFrom from = record.times_from;
    report.findings.push_back(told((from == TimesFrom::kUser ? told_by_user(*factor, record) : unit_of(*factor)) +
                                   "velocities are as much too large for the displacement, accelerations by the "
                                   "square of that" +
                                   remedy(from)));
    return;
  }
  if (record.times_from == TimesFrom::kColumn) name_the_times_too(record, report);
  const double slowest = model != nullptr ? slowest_mode_Hz(*model) : 0, rate_Hz = 1.0 / record.sample_period_s;
  if (slowest > 0.5 * rate_Hz)
    report.findings.push_back(
        told(fmt::format("the rig's slowest mode lies at {:.3g} Hz or above, and samples at {:.3g} Hz cannot show "
                         "it: {}?",
                         slowest, rate_Hz,
                         record.times_from == TimesFrom::kUser ? "is --sample-rate in samples per second"
                                                               : "are the times in seconds"),
             Weight::kDoubt));
}

}  // namespace host_sim::data_check
