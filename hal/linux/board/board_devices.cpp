#include "hal/linux/board/board_devices.hpp"

#include <cstdlib>

#include "firmware/can_protocol/frame_table.hpp"
#include "hal/linux/board/driver_rails.hpp"
#include "hal/linux/board/safe_outputs.hpp"

namespace board {

BoardDevices::BoardDevices(const BoardFile& file)
    : file_(file),
      configuration_(file.controller),
      iio_samples_(clock_),
      direct_samples_(clock_),
      systemd_(std::getenv("NOTIFY_SOCKET")),
      watchdog_(clock_, systemd_, device_watchdog_),
      store_(files_) {}

std::string BoardDevices::open() {
  hal::SocketCan::Options options;
  options.fd = file_.controller.node.can_fd;
  // Network commands, SYNC, requests to this node. The sensors' frames have a socket of their own.
  namespace can = firmware::can;
  const uint8_t node = file_.controller.node.node;
  const uint32_t ids[] = {can::frame_id(can::kNetworkCommand.ids, node), can::frame_id(can::kSync.ids, node),
                          can::frame_id(can::kSdoRequest.ids, node)};
  bus_.receive_only(ids, 3);
  if (file_.drive == DriveKind::kCan) options.confirmed_id = can::frame_id(can::kDrive.ids, node);
  std::string fault = bus_.open(file_.can_interface, options);
  if (fault.empty()) fault = open_samples();
  if (fault.empty()) fault = take_ranges();
  if (fault.empty() && file_.drive == DriveKind::kIio) fault = iio_drive_.open(file_.iio_drive);
  if (fault.empty()) fault = open_lines();
  if (fault.empty()) fault = files_.open(file_.state_folder);
  if (fault.empty()) fault = worker_.open(file_.priority > 0);
  if (fault.empty()) fault = store_worker_.open(false);
  // Last of all: a start that fails before it leaves no armed watchdog behind, so no board that restarts for ever.
  if (fault.empty()) fault = open_watchdog();
  return fault;
}

std::string BoardDevices::open_watchdog() {
  const std::string device = hal::watchdog_device(file_.watchdog_device);
  if (device.empty()) return "";
  const std::string fault = device_watchdog_.open(device, file_.watchdog_timeout_s);
  const bool asked_for = file_.watchdog_device != "auto";
  if (!fault.empty() && asked_for) return fault;
  guard_ = fault.empty() ? "guarded by " + device : "no hardware watchdog (" + fault + ")";
  return "";
}

std::string BoardDevices::open_samples() {
  const SampleSettings& samples = file_.samples;
  if (samples.kind == SampleKind::kIioBuffer)
    return iio_samples_.open({samples.device, samples.trigger, samples.rate_Hz}, samples.channels);
  if (samples.kind == SampleKind::kIioDirect)
    return direct_samples_.open({samples.device, samples.rate_Hz}, samples.channels);
  const firmware::SensorPlan plan = firmware::sensor_plan(file_.controller.core, samples.wiring);
  uint32_t ids[firmware::kMaxSensorFrames];
  if (!sensor_bus_.receive_only(ids, firmware::sensor_ids(plan, ids))) return "too many sensor frames for one socket";
  can_samples_.emplace(sensor_bus_, plan);
  hal::SocketCan::Options options;
  options.fd = samples.wiring == firmware::SensorWiring::kFd;
  options.error_frames = false;
  return sensor_bus_.open(file_.can_interface, options);
}

std::string BoardDevices::take_ranges() {
  const auto range = [this](const hal::IioChannel& channel) {
    return file_.samples.kind == SampleKind::kIioBuffer ? iio_samples_.range(channel.node, channel.quantity)
                                                        : direct_samples_.range(channel.node, channel.quantity);
  };
  notes_ = wide_words(file_.samples.channels, range);
  return take_driver_rails(file_.samples.channels, range, configuration_.core, file_.told);
}

std::string BoardDevices::open_lines() {
  const auto open = [](auto& line, const LineSetting& setting) {
    return setting.line.empty() ? std::string() : line.open(setting.line, setting.options);
  };
  std::string fault = open(stop_line_, file_.emergency_stop);
  if (fault.empty()) fault = open(relay_line_, file_.relay);
  if (fault.empty()) fault = open(lamp_line_, file_.ready_lamp);
  if (fault.empty()) fault = open(sync_line_, file_.sync);
  return fault;
}

firmware::Ports BoardDevices::ports() {
  hal::SampleSource* samples = nullptr;
  switch (file_.samples.kind) {
    case SampleKind::kCan:
      samples = &*can_samples_;
      break;
    case SampleKind::kIioBuffer:
      samples = &iio_samples_;
      break;
    case SampleKind::kIioDirect:
      samples = &direct_samples_;
      break;
  }
  hal::DriveOutput* drive = &no_drive_;
  if (file_.drive == DriveKind::kIio) drive = &iio_drive_;
  const auto input = [&](const LineSetting& setting, hal::GpioInput& line) -> hal::DigitalInput& {
    return setting.line.empty() ? static_cast<hal::DigitalInput&>(no_input_) : line;
  };
  const auto output = [&](const LineSetting& setting, hal::GpioOutput& line) -> hal::DigitalOutput& {
    return setting.line.empty() ? static_cast<hal::DigitalOutput&>(no_output_) : line;
  };
  return {clock_,
          *samples,
          bus_,
          *drive,
          output(file_.relay, relay_line_),
          output(file_.ready_lamp, lamp_line_),
          input(file_.emergency_stop, stop_line_),
          file_.sync.line.empty() ? nullptr : &sync_line_,
          watchdog_,
          store_,
          &worker_,
          &store_worker_};
}

int BoardDevices::waits(pollfd (&waits)[kMaxWaits]) const {
  int count = 0;
  const auto add = [&](int descriptor) {
    if (descriptor >= 0) waits[count++] = {descriptor, POLLIN, 0};
  };
  add(bus_.descriptor());
  add(file_.samples.kind == SampleKind::kIioBuffer ? iio_samples_.descriptor() : sensor_bus_.descriptor());
  add(stop_line_.descriptor());
  add(sync_line_.descriptor());
  return count;
}

bool BoardDevices::make_safe() {
  const bool relay_off = file_.relay.line.empty() || relay_line_.set(false);
  const bool zero = (file_.drive != DriveKind::kIio || iio_drive_.write(0)) &&
                    (file_.drive != DriveKind::kCan || send_zero_drive(bus_, file_.controller.node.node));
  return relay_off && zero;
}

}  // namespace board
