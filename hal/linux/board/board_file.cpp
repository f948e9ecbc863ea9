#include "hal/linux/board/board_file.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "hal/linux/board/bus_check.hpp"
#include "hal/linux/board/excitation_section.hpp"
#include "hal/linux/board/output_sections.hpp"
#include "hal/linux/board/told_motion.hpp"
#include "hal/rig_file/channel_name.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/toml/rig_from_toml.hpp"
#include "hal/rig_file/whole_cycles.hpp"

namespace board {
namespace {

constexpr double kMostDirect_Hz = 4000.0;  // the controller's shortest tick (run.cpp) takes one sample

void read_node(const Section& section, BoardFile& board) {
  firmware::NodeConfiguration& node = board.controller.node;
  read_identity(section, board);
  node.heartbeat_ms = static_cast<uint16_t>(section.whole("heartbeat_ms", 100, 0, 65535));
  if (node.heartbeat_ms != 0 && node.heartbeat_ms < 10)
    section.refuse("heartbeat_ms", "would fill the bus, expected 0 (none) or 10 to 65535");
  node.status_ms = static_cast<uint16_t>(section.whole("status_ms", 100, 10, 65535));
  node.emergency_inhibit_ms = static_cast<uint16_t>(section.whole("emergency_inhibit_ms", 100, 0, 65535));
  const double window_s = section.number("window_s", 1.0, 0.05, 1.0);
  node.window_samples = static_cast<uint32_t>(std::lround(window_s * board.samples.rate_Hz));
  node.sync_closes_window = section.flag("sync_closes_window", true);
  node.listen_on_command = section.flag("listen_on_command", false);
  for (size_t i = 0; i < board.rig.dofs.size(); ++i)
    if (board.rig.dofs[i].rotating) node.rotating_nodes |= 1u << i;
  board.state_folder = section.text("state_folder", "/var/lib/rig_controller");
  board.priority = static_cast<int>(section.whole("priority", 80, 0, 99));
}

void read_samples(const Section& section, BoardFile& board) {
  SampleSettings& samples = board.samples;
  samples.kind = static_cast<SampleKind>(section.choice("source", {"can", "iio", "iio_direct"}));
  samples.rate_Hz = section.number("rate_Hz", 1000.0, 10.0, 20000.0);
  if (samples.kind == SampleKind::kCan) {
    samples.wiring = static_cast<firmware::SensorWiring>(section.choice("wiring", {"16", "24", "fd", "pairs"}) + 1);
    for (const char* key : {"device", "trigger"})
      if (section.has(key)) section.refuse(key, "stands beside source = \"can\", expected it with an IIO source only");
  } else {
    if (section.has("wiring")) section.refuse("wiring", "is of sensor frames, expected it with source = \"can\" only");
    if (!section.has("device")) section.refuse("device", "is missing, expected the name of an IIO device");
    samples.device = section.text("device", "");
    samples.trigger = section.text("trigger", "");
    if (samples.kind == SampleKind::kIioDirect && samples.rate_Hz > kMostDirect_Hz)
      section.refuse("rate_Hz", "is " + readable(samples.rate_Hz) + ", expected at most " + readable(kMostDirect_Hz) +
                                    " without a buffer: each sample is asked for by itself");
  }
  firmware::LimitConfiguration& limits = board.controller.limits;
  limits.saturated_in_row = static_cast<uint16_t>(section.whole("saturated_in_row", 3, 1, 65535));
  limits.lost_in_row = static_cast<uint16_t>(section.whole("lost_in_row", 3, 1, 65535));
  const double period_ms = 1e3 / samples.rate_Hz;
  const double timeout_ms = section.number("timeout_ms", std::max(10.0, 3.0 * period_ms), 0.1, 10000.0);
  if (timeout_ms < 2.0 * period_ms)
    section.refuse("timeout_ms", "is " + readable(timeout_ms) + " at " + readable(samples.rate_Hz) +
                                     " samples a second, expected at least two periods of them");
  limits.sample_timeout_us = static_cast<uint32_t>(std::lround(timeout_ms * 1000.0));
}

// A calibrated channel for each [[channel]]; for IIO also the element that feeds it.
std::vector<rig_file::ChannelCalibration> read_channels(const toml::table& root, BoardFile& board) {
  std::vector<rig_file::ChannelCalibration> calibrations;
  const auto tables = rig_file::table_array({board.path, ""}, root, "channel");
  const bool iio = board.samples.kind != SampleKind::kCan;
  for (size_t i = 0; i < tables.size(); ++i) {
    const rig_file::ChannelEntry& entry = board.rig.channels[i];
    const rig_file::ChannelName name = *rig_file::parse_channel_name(entry.name);
    const Section section(board.path, "channel " + std::to_string(i + 1), tables[i],
                          {"name", "delay_us", "unit_per_code", "offset_code", "full_scale_code", "lowest_code",
                           "highest_code", "element", "limit_code"});
    if (entry.unit_per_code == 0.0) section.refuse("unit_per_code", "is missing, expected SI units per converter code");
    if (iio != section.has("element"))
      section.refuse("element",
                     iio ? "is missing, expected the IIO element that feeds " + entry.name + ", such as \"in_voltage0\""
                         : "stands beside source = \"can\", expected it with an IIO source only");
    rig_file::ChannelCalibration calibration;
    calibration.quantity = name.quantity;
    calibration.dof = name.dof;
    if (board.samples.kind == SampleKind::kCan && board.samples.wiring == firmware::SensorWiring::k16 &&
        name.quantity != firmware::Quantity::kForce) {
      calibration.lowest_code = INT16_MIN;  // the rails of the frame, where the sensor's are not told
      calibration.highest_code = INT16_MAX;
    }
    calibration.take(entry);
    calibrations.push_back(calibration);
    const auto node = static_cast<uint8_t>(rig_file::node_index(name.dof));
    board.controller.limits.response_limit_code[node][static_cast<int>(name.quantity)] =
        static_cast<int32_t>(section.whole("limit_code", 0, 0, 8388607));
    const bool rails_told = entry.lowest_code != entry.highest_code;
    if (iio) board.samples.channels.push_back({section.text("element", ""), node, name.quantity, rails_told});
  }
  if (calibrations.empty())
    throw rig_file::RigFileError(board.path, 0, "key \"channel\"", "is missing, expected at least one [[channel]]");
  constexpr size_t kMostInPairs = 2 * firmware::kMaxNodes;
  if (board.samples.wiring == firmware::SensorWiring::kPairs && calibrations.size() > kMostInPairs)
    throw rig_file::RigFileError(board.path, 0, "samples, key \"wiring\"",
                                 "is \"pairs\" for " + std::to_string(calibrations.size()) +
                                     " channels, expected at most " + std::to_string(kMostInPairs));
  return calibrations;
}

// What moves a rig must be able to stop it.
void require_stop(const Section& drive, const BoardFile& board) {
  if (board.controller.programme.level_count == 0) return;
  if (board.drive == DriveKind::kNone)
    drive.refuse("output", "is missing, expected \"can\" or \"iio\": the excitation programme has levels");
  if (board.emergency_stop.line.empty() || board.relay.line.empty())
    throw rig_file::RigFileError(board.path, 0,
                                 board.relay.line.empty() ? "gpio, key \"relay\"" : "gpio, key \"emergency_stop\"",
                                 "is missing, expected both lines: the excitation programme has levels");
}

// A wire that breaks leaves the line where its bias pulls it: is that "pressed"?
bool broken_wire_stops(const hal::LineOptions& line) {
  return line.active_low ? line.bias == hal::LineBias::kPullDown : line.bias == hal::LineBias::kPullUp;
}

// Channels of sensor frames that have 24 bits because nobody has said less, where slopes are made of them: a frame does not tell how
// wide its sensor is.
std::string slopes_of_untold_width(const BoardFile& board) {
  std::string text;
  if (board.samples.kind != SampleKind::kCan || board.samples.wiring == firmware::SensorWiring::k16) return text;
  for (const rig_file::ChannelEntry& entry : board.rig.channels) {
    const rig_file::ChannelName name = *rig_file::parse_channel_name(entry.name);
    const int source = static_cast<int>(name.quantity);
    bool slopes = false;
    for (int q = source + 1; q < firmware::kQuantities; ++q) {
      const firmware::SignalConfiguration& signal = board.controller.core.signals[rig_file::node_index(name.dof)][q];
      slopes = slopes || (signal.derived && signal.source == source);
    }
    if (slopes && entry.lowest_code == entry.highest_code)
      text += "  warning: " + entry.name +
              ": no full_scale_code: its slopes have steps for 24 bits, which hide those of a converter with fewer "
              "(docs/board.md)\n";
  }
  return text;
}

}  // namespace

BoardFile read_board_file(const std::string& path) {
  const toml::table root = rig_file::parse_toml_file(path);
  BoardFile board;
  board.path = path;
  const rig_file::ReadOptions options{{"node", "can", "samples", "gpio", "drive", "excitation"},
                                      {"element", "limit_code"}};
  board.rig = rig_file::rig_from_toml(root, path, options);
  rig_file::require_unknowns(board.rig);
  const Section samples(path, "samples", sub_table(path, root, "samples"),
                        {"source", "rate_Hz", "wiring", "device", "trigger", "saturated_in_row", "lost_in_row",
                         "timeout_ms", "cycle_Hz", "slowest_Hz", "fastest_Hz"});
  read_samples(samples, board);
  read_node(node_section(path, root), board);
  read_can(can_section(path, root), board);
  read_gpio(gpio_section(path, root), board);
  const Section drive = drive_section(path, root);
  read_drive(drive, board);
  const double cycle_Hz = samples.number("cycle_Hz", 0.0, 0.001, 10000.0);
  if (cycle_Hz > 0.0 && !rig_file::can_be_whole(board.samples.rate_Hz / cycle_Hz))
    samples.refuse("cycle_Hz", "is " + readable(cycle_Hz) + " at " + readable(board.samples.rate_Hz) +
                                   " samples a second, expected at least four of them in a cycle");
  board.controller.core = rig_file::compile_rig(board.rig, 1.0 / board.samples.rate_Hz, read_channels(root, board));
  read_excitation(path, root, drive, board.samples.rate_Hz, cycle_Hz, board.controller);
  board.told = told_motion(samples, board, cycle_Hz);
  rig_file::plan_signals(board.controller.core, board.told);
  board.controller.core.probe_products_per_sample = static_cast<uint16_t>(
      node_section(path, root).whole("probe_products_per_sample", firmware::kDefaultProbes, 0, firmware::kAllProbes));
  require_stop(drive, board);
  fit_float_estimates(board);
  return board;
}

std::string describe(const BoardFile& board) {
  std::ostringstream text;
  const char* kinds[] = {"sensor frames on CAN", "buffered IIO", "single IIO reads"};
  text << board.path << ": " << (board.rig.name.empty() ? "a rig" : board.rig.name) << ", " << board.rig.dofs.size()
       << " DOF, " << board.rig.links.size() << " links, " << rig_file::parameter_table(board.rig).size()
       << " parameters to estimate\n"
       << "  samples: " << kinds[static_cast<int>(board.samples.kind)] << ", " << board.rig.channels.size()
       << " channels, " << board.samples.rate_Hz << " Hz\n"
       << "  node " << int(board.controller.node.node) << " on " << board.can_interface
       << (board.controller.node.can_fd ? " (CAN FD)" : "") << "\n"
       << "  bus: " << check_bus(board).load << "\n";
  text << slopes_of_untold_width(board);
  if (board.controller.programme.level_count == 0)
    text << "  listens only: no excitation levels\n";
  else
    text << "  drives " << int(board.controller.programme.level_count) << " levels; stop line \""
         << board.emergency_stop.line << "\", relay \"" << board.relay.line << "\"\n";
  const hal::LineOptions& stop = board.emergency_stop.options;
  if (!board.emergency_stop.line.empty() && !broken_wire_stops(stop))
    text << "  warning: emergency_stop: with " << (stop.active_low ? "active_low" : "active high") << " and bias \""
         << bias_words()[static_cast<size_t>(stop.bias)] << "\" a broken wire "
         << (stop.bias == hal::LineBias::kPullUp || stop.bias == hal::LineBias::kPullDown ? "reads as released"
                                                                                          : "may read as released")
         << "; a normally closed contact to ground with bias \"pull_up\" stops then too (docs/board.md)\n";
  return text.str();
}

}  // namespace board
