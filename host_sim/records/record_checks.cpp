#include "host_sim/records/record_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/records/data_file_error.hpp"

namespace host_sim {
namespace {

constexpr double kStepTolerance = 0.01;

std::string seconds(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g s", value);
  return text;
}

}  // namespace

Channel channel_of_name(const std::string& name, const rig_file::RigModel& model, const std::string& file,
                        size_t line) {
  const std::string fault = rig_file::channel_name_fault(name, model);
  if (!fault.empty()) throw DataFileError(file, line, "channel \"" + name + "\": " + fault);
  const rig_file::ChannelName parsed = *rig_file::parse_channel_name(name);
  Channel channel;
  channel.name = name;
  channel.quantity = static_cast<Quantity>(parsed.quantity);
  channel.dof = parsed.dof;
  return channel;
}

void set_time_base(const std::vector<double>& time_s, size_t first_line, Record& record) {
  if (time_s.size() < 2)
    throw DataFileError(record.file, 0, "holds " + std::to_string(time_s.size()) + " samples, expected at least 2");
  std::vector<double> steps(time_s.size() - 1);
  for (size_t i = 0; i < steps.size(); ++i) steps[i] = time_s[i + 1] - time_s[i];
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double usual = *middle;
  for (size_t i = 0; i < steps.size(); ++i)
    if (!(usual > 0.0) || std::abs(steps[i] - usual) > kStepTolerance * usual)
      throw DataFileError(record.file, first_line + i + 1,
                          "t_s steps by " + seconds(steps[i]) + ", expected a constant step" +
                              (usual > 0.0 ? " of " + seconds(usual) + " within 1 %" : " above 0"));
  record.start_s = time_s.front();
  record.sample_period_s = (time_s.back() - time_s.front()) / static_cast<double>(steps.size());
}

void require_motion_channels(const Record& record, const rig_file::RigModel& model) {
  const auto require = [&](int dof, bool rotates) {
    for (const Quantity quantity : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
      if (record.find(quantity, dof) != nullptr) return;
    const auto name = [&](firmware::Quantity quantity) {
      return rig_file::format_channel_name({quantity, dof, rotates});
    };
    throw DataFileError(record.file, 0,
                        std::string("no motion of ") +
                            (dof == rig_file::kBase ? "the base" : "DOF " + std::to_string(dof)) +
                            " is recorded, expected a column " + name(firmware::Quantity::kDisplacement) + ", " +
                            name(firmware::Quantity::kVelocity) + " or " + name(firmware::Quantity::kAcceleration));
  };
  for (size_t i = 0; i < model.dofs.size(); ++i) require(static_cast<int>(i + 1), model.dofs[i].rotating);
  for (const rig_file::Link& link : model.links)
    if (link.b == rig_file::kBase) require(rig_file::kBase, rig_file::link_rotates(model, link));
}

void require_same_channels(const std::vector<Record>& records) {
  for (const Record& record : records) {
    const Record& first = records.front();
    if (std::abs(record.sample_period_s / first.sample_period_s - 1.0) > kStepTolerance)
      throw DataFileError(record.file, 0,
                          "sampled every " + seconds(record.sample_period_s) + ", expected " +
                              seconds(first.sample_period_s) + " as in " + first.file);
    for (const Channel& channel : first.channels)
      if (record.find(channel.quantity, channel.dof) == nullptr)
        throw DataFileError(record.file, 0,
                            "lacks " + channel.name + ", expected the same channels as in " + first.file);
    for (const Channel& channel : record.channels)
      if (first.find(channel.quantity, channel.dof) == nullptr)
        throw DataFileError(record.file, 0, "has " + channel.name + ", expected the same channels as in " + first.file);
  }
}

}  // namespace host_sim
