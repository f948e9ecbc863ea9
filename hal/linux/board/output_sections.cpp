#include "hal/linux/board/output_sections.hpp"

#include <exception>
#include <functional>

namespace board {
namespace {

LineSetting read_line(const Section& gpio, const std::string& file, const char* key) {
  LineSetting setting;
  const toml::node* node = gpio.node(key);
  if (node == nullptr) return setting;
  if (!node->is_table()) {
    setting.line = gpio.text(key, "");
    return setting;
  }
  const Section section(file, std::string("gpio, key \"") + key + "\"", node->as_table(),
                        {"line", "active_low", "bias"});
  if (!section.has("line")) section.refuse("line", "is missing, expected a line name or chip:offset");
  setting.line = section.text("line", "");
  setting.options.active_low = section.flag("active_low", false);
  setting.options.bias = static_cast<hal::LineBias>(section.choice("bias", bias_words()));
  return setting;
}

// Runs one reader; what it refuses becomes a problem instead of the end.
void attempt(std::vector<std::string>& problems, const std::function<void()>& reader) {
  try {
    reader();
  } catch (const std::exception& error) {
    problems.push_back(error.what());
  }
}

}  // namespace

const std::vector<std::string>& bias_words() {
  static const std::vector<std::string> words = {"as_is", "pull_up", "pull_down", "disabled"};
  return words;
}

Section node_section(const std::string& file, const toml::table& root) {
  return Section(
      file, "node", sub_table(file, root, "node"),
      {"id", "heartbeat_ms", "status_ms", "emergency_inhibit_ms", "window_s", "sync_closes_window", "listen_on_command",
       "state_folder", "priority", "watchdog", "watchdog_timeout_s", "probe_products_per_sample"});
}

Section can_section(const std::string& file, const toml::table& root) {
  return Section(file, "can", sub_table(file, root, "can"),
                 {"interface", "fd", "float_estimates", "bit_rate_kbit_s", "data_bit_rate_kbit_s"});
}

Section gpio_section(const std::string& file, const toml::table& root) {
  return Section(file, "gpio", sub_table(file, root, "gpio"), {"emergency_stop", "relay", "ready_lamp", "sync"});
}

Section drive_section(const std::string& file, const toml::table& root) {
  return Section(file, "drive", sub_table(file, root, "drive"),
                 {"output", "device", "element", "zero_code", "full_scale_code", "limit", "slew_per_s"});
}

void read_identity(const Section& node, BoardFile& board) {
  board.controller.node.node = static_cast<uint8_t>(node.whole("id", 1, 1, 7));
  board.watchdog_device = node.text("watchdog", "auto");
  board.watchdog_timeout_s = static_cast<int>(node.whole("watchdog_timeout_s", 5, 1, 600));
}

void read_can(const Section& section, BoardFile& board) {
  board.can_interface = section.text("interface", "can0");
  board.controller.node.can_fd = section.flag("fd", false);
  board.bit_rates.nominal = 1000 * section.whole("bit_rate_kbit_s", 1000, 10, 1000);
  board.bit_rates.data = 1000 * section.whole("data_bit_rate_kbit_s", 2000, 10, 8000);
  if (board.bit_rates.data < board.bit_rates.nominal && section.has("data_bit_rate_kbit_s"))
    section.refuse("data_bit_rate_kbit_s", "is below bit_rate_kbit_s, expected at least as much");
  if (section.has("float_estimates"))
    board.controller.node.float_estimates =
        static_cast<firmware::FloatEstimates>(section.choice("float_estimates", {"auto", "on", "off"}));
}

void read_gpio(const Section& section, BoardFile& board) {
  board.emergency_stop = read_line(section, board.path, "emergency_stop");
  board.relay = read_line(section, board.path, "relay");
  board.ready_lamp = read_line(section, board.path, "ready_lamp");
  board.sync = read_line(section, board.path, "sync");
}

void read_drive(const Section& section, BoardFile& board) {
  board.drive =
      section.present() ? static_cast<DriveKind>(section.choice("output", {"none", "can", "iio"})) : DriveKind::kNone;
  board.controller.node.drive_on_can = board.drive == DriveKind::kCan;
  const bool iio = board.drive == DriveKind::kIio;
  for (const char* key : {"device", "element"})
    if (iio != section.has(key))
      section.refuse(key, iio ? "is missing, expected the IIO device and element of the shaker's converter"
                              : "is of a converter, expected it with output = \"iio\" only");
  board.iio_drive.device = section.text("device", "");
  board.iio_drive.element = section.text("element", "");
  board.iio_drive.zero_code = static_cast<int32_t>(section.whole("zero_code", 0, -8388608, 16777215));
  board.iio_drive.full_scale_code = static_cast<int32_t>(section.whole("full_scale_code", 32767, 1, 8388607));
}

BoardFile read_outputs(const std::string& path, std::vector<std::string>& problems) {
  BoardFile board;
  board.path = path;
  attempt(problems, [&] {
    const toml::table root = rig_file::parse_toml_file(path);
    attempt(problems, [&] { read_gpio(gpio_section(path, root), board); });
    attempt(problems, [&] { read_can(can_section(path, root), board); });
    attempt(problems, [&] { read_drive(drive_section(path, root), board); });
    attempt(problems, [&] { read_identity(node_section(path, root), board); });
  });
  return board;
}

}  // namespace board
