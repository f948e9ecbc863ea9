#include "hal/linux/board/safe_outputs.hpp"

#include <time.h>

#include <algorithm>
#include <cstdio>

#include "firmware/can_protocol/messages/packing.hpp"
#include "hal/linux/board/output_sections.hpp"
#include "hal/linux/gpio/gpio_line.hpp"
#include "hal/linux/iio/iio_drive_output.hpp"
#include "hal/linux/system/watchdogs.hpp"

namespace board {
namespace {

constexpr int kDone = 0, kFailed = 1;

std::string switch_off(const LineSetting& setting) {
  if (setting.line.empty()) return "";
  hal::GpioOutput line;
  const std::string fault = line.open(setting.line, setting.options);  // requested as inactive
  if (!fault.empty()) return fault;
  return line.set(false) ? "" : "GPIO line \"" + setting.line + "\" does not take \"off\"";
}

std::string zero_converter(const BoardFile& file) {
  hal::IioDriveOutput drive;
  const std::string fault = drive.open(file.iio_drive);
  if (!fault.empty()) return fault;
  return drive.write(0) ? "" : "IIO device \"" + file.iio_drive.device + "\" does not take zero";
}

std::string zero_on_can(const BoardFile& file) {
  hal::SocketCan bus;
  hal::SocketCan::Options options;
  options.error_frames = options.data_frames = false;
  const std::string fault = bus.open(file.can_interface, options);
  if (!fault.empty()) return fault;
  return send_zero_drive(bus, file.controller.node.node) ? ""
                                                         : "CAN interface " + file.can_interface + " takes no frame";
}

}  // namespace

bool send_zero_drive(hal::SocketCan& bus, int node) {
  const firmware::CanFrame message = firmware::pack_drive(node, {0, 0, firmware::DriveState::kStopped});
  hal::CanFrame frame;
  frame.id = message.id;
  frame.length = message.length;
  std::copy_n(message.data, message.length, frame.data);
  constexpr int kTries = 50;
  for (int i = 0; i < kTries; ++i) {
    hal::CanFrame ignored;  // what comes tells which of the frames before have been on the bus
    while (bus.receive(ignored) == hal::CanResult::kDone) {
    }
    const hal::CanResult result = bus.send(frame);
    if (result != hal::CanResult::kQueueFull) return result == hal::CanResult::kDone;
    const timespec millisecond{0, 1000000};
    ::nanosleep(&millisecond, nullptr);
  }
  return false;
}

std::vector<std::string> bring_outputs_to_safe_state(const BoardFile& file) {
  std::vector<std::string> faults;
  const auto keep = [&](const std::string& fault) {
    if (!fault.empty()) faults.push_back(fault);
  };
  keep(switch_off(file.relay));  // first: it cuts the power whatever the amplifier is told
  if (file.drive == DriveKind::kIio) keep(zero_converter(file));
  if (file.drive == DriveKind::kCan) keep(zero_on_can(file));
  keep(switch_off(file.ready_lamp));
  return faults;
}

int make_board_safe(const std::string& path) {
  std::vector<std::string> faults;
  const BoardFile file = read_outputs(path, faults);
  const std::vector<std::string> undone = bring_outputs_to_safe_state(file);
  faults.insert(faults.end(), undone.begin(), undone.end());
  for (const std::string& fault : faults) std::fprintf(stderr, "rig_controller --safe: %s\n", fault.c_str());
  if (!faults.empty()) return kFailed;
  hal::DeviceWatchdog watchdog;
  const std::string device = hal::watchdog_device(file.watchdog_device);
  if (device.empty() || !hal::watchdog_is_armed(device)) return kDone;
  if (watchdog.open(device, file.watchdog_timeout_s).empty()) watchdog.disarm();  // else somebody else's
  return kDone;
}

}  // namespace board
