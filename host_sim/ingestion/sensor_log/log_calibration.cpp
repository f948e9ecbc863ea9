#include "host_sim/ingestion/sensor_log/log_calibration.hpp"

#include <cmath>

#include "firmware/can_protocol/messages/packing.hpp"
#include "hal/rig_file/channel_name.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "host_sim/records/files/data_file_error.hpp"

namespace host_sim {
namespace {

namespace can = firmware::can;
using firmware::SensorWiring;

constexpr uint8_t kMotionBit = 1, kForceBit = 2;

// The frames that carry samples: their wiring, their bit in SensorPlan::expected and the quantities in them (bit q).
struct SensorFrameKind {
  const can::FrameDescription* frame;
  SensorWiring wiring;
  uint8_t bit;
  uint8_t quantities;
};
constexpr SensorFrameKind kKinds[] = {{&can::kSensorMotion16, SensorWiring::k16, kMotionBit, 0b1110},
                                      {&can::kSensorForce, SensorWiring::k16, kForceBit, 0b0001},
                                      {&can::kSensorMotion24, SensorWiring::k24, kMotionBit, 0b0110},
                                      {&can::kSensorForce24, SensorWiring::k24, kForceBit, 0b1001},
                                      {&can::kSensorFd, SensorWiring::kFd, kMotionBit, 0b1111},
                                      {&can::kSensorPair24, SensorWiring::kPairs, kMotionBit, 0}};

int dof_of_node(int node) { return node == firmware::kBaseNode ? rig_file::kBase : node + 1; }

// All samples of a log are read with one calibration.
[[noreturn]] void refuse_change(const char* frame, const rig_file::ChannelName& channel, const std::string& file,
                                size_t line) {
  throw DataFileError(file, line,
                      std::string("frame ") + frame + " of " + rig_file::format_channel_name(channel) +
                          " says another value than before, expected one calibration: part the log there");
}

}  // namespace

void LogCalibration::learn(const firmware::CanFrame& message, const std::string& file, size_t line) {
  int node = 0, member = 0;
  for (const SensorFrameKind& kind : kKinds) {
    if (!can::is_frame(*kind.frame, message, node, member)) continue;
    any_sensor_frame_ = true;
    SensorWiring& wiring = plan_.wiring[member];
    if (wiring != SensorWiring::kNone && wiring != kind.wiring)
      throw DataFileError(file, line,
                          std::string("frame ") + kind.frame->name +
                              " of a DOF that also sent frames of another wiring, " +
                              "expected one wiring for each DOF");
    wiring = kind.wiring;
    plan_.expected[member] = static_cast<uint8_t>(plan_.expected[member] | kind.bit);
    return;
  }
  firmware::ChannelScaling scaling;
  firmware::ChannelRange range;
  if (firmware::unpack_scaling(message, node, scaling) && scaling.place >= 1 && scaling.place <= firmware::kMaxNodes) {
    Description& channel = described_[scaling.place - 1][static_cast<int>(scaling.quantity)];
    const double unit_per_code = scaling.unit_per_code * std::pow(10.0, scaling.exponent);
    if (channel.known && (channel.rotating != scaling.rotating || channel.unit_per_code != unit_per_code))
      refuse_change("scaling", {scaling.quantity, dof_of_node(scaling.place - 1), scaling.rotating}, file, line);
    channel.known = true;
    channel.rotating = scaling.rotating;
    channel.unit_per_code = unit_per_code;
  } else if (firmware::unpack_range(message, node, range) && range.place >= 1 && range.place <= firmware::kMaxNodes) {
    Description& channel = described_[range.place - 1][static_cast<int>(range.quantity)];
    if (channel.offset_known && channel.offset_code != range.offset_code)
      refuse_change("range", {range.quantity, dof_of_node(range.place - 1), channel.rotating}, file, line);
    channel.offset_known = true;
    channel.offset_code = range.offset_code;
  }
}

// The channels of `sensor_pair_24` are all those that the log describes or, where it describes none, the rig file.
void LogCalibration::lay_out_pairs(const std::string& file, const rig_file::RigModel& model) {
  int pairs = 0;
  while (pairs < firmware::kMaxNodes && plan_.wiring[pairs] == SensorWiring::kPairs) ++pairs;
  if (pairs == 0) return;
  bool known[firmware::kMaxNodes][firmware::kQuantities] = {};
  for (const rig_file::ChannelEntry& entry : model.channels)
    if (const auto name = rig_file::parse_channel_name(entry.name); name && !described())
      known[rig_file::node_index(name->dof)][static_cast<int>(name->quantity)] = true;
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int quantity = 0; quantity < firmware::kQuantities; ++quantity)
      if (described_[node][quantity].known || known[node][quantity])
        firmware::add_to_pairs(plan_, node, static_cast<firmware::Quantity>(quantity));
  if ((plan_.channel_count + 1) / 2 != pairs)
    throw DataFileError(file, 0,
                        "holds " + std::to_string(pairs) + " frames sensor_pair_24 for each sample and describes " +
                            std::to_string(plan_.channel_count) +
                            " channels, expected a frame for every two: frames `scaling` in the log, or a [[channel]] "
                            "for each in the rig file");
}

bool LogCalibration::described() const {
  for (const auto& node : described_)
    for (const Description& channel : node)
      if (channel.known) return true;
  return false;
}

bool LogCalibration::carried(int node, int quantity) const {
  for (int i = 0; i < plan_.channel_count; ++i)
    if (plan_.channels[i].node == node && plan_.channels[i].quantity == quantity) return true;
  for (const SensorFrameKind& kind : kKinds)
    if (kind.wiring == plan_.wiring[node] && (plan_.expected[node] & kind.bit) != 0 &&
        (kind.quantities >> quantity & 1) != 0)
      return true;
  return false;
}

std::vector<LogChannel> LogCalibration::channels(const std::string& file, const rig_file::RigModel& model) const {
  std::vector<LogChannel> channels;
  bool taken[firmware::kMaxNodes][firmware::kQuantities] = {};
  for (const rig_file::ChannelEntry& entry : model.channels) {
    const auto name = rig_file::parse_channel_name(entry.name);
    if (!name || entry.unit_per_code == 0.0) continue;
    const int node = rig_file::node_index(name->dof), quantity = static_cast<int>(name->quantity);
    if (!carried(node, quantity))
      throw DataFileError(file, 0, "carries no codes of " + entry.name + ", which the rig file calibrates");
    taken[node][quantity] = true;
    channels.push_back({entry.name, node, quantity, entry.unit_per_code, entry.offset_code});
  }
  for (int node = 0; node < firmware::kMaxNodes; ++node) {
    for (int quantity = 0; quantity < firmware::kQuantities; ++quantity) {
      const Description& channel = described_[node][quantity];
      if (!channel.known || taken[node][quantity] || !carried(node, quantity)) continue;
      const rig_file::ChannelName name{static_cast<firmware::Quantity>(quantity), dof_of_node(node), channel.rotating};
      channels.push_back(
          {rig_file::format_channel_name(name), node, quantity, channel.unit_per_code, channel.offset_code});
    }
  }
  if (channels.empty())
    throw DataFileError(file, 0,
                        "holds codes without a calibration, expected frames `scaling` and `range` in the log or "
                        "[[channel]] entries with unit_per_code in the rig file");
  return channels;
}

}  // namespace host_sim
