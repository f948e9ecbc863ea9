// The devices that a board's file names, opened, and the controller's ports made of them.
#pragma once
#include <poll.h>

#include <memory>
#include <optional>
#include <string>

#include "firmware/rig_controller/bus/can_sample_source.hpp"
#include "firmware/rig_controller/rig_controller.hpp"
#include "hal/linux/board/board_file.hpp"
#include "hal/linux/can/socket_can.hpp"
#include "hal/linux/gpio/gpio_line.hpp"
#include "hal/linux/iio/iio_buffer_source.hpp"
#include "hal/linux/iio/iio_direct_source.hpp"
#include "hal/linux/iio/iio_drive_output.hpp"
#include "hal/linux/store/file_configuration_store.hpp"
#include "hal/linux/store/posix_file_operations.hpp"
#include "hal/linux/system/monotonic_clock.hpp"
#include "hal/linux/system/watchdogs.hpp"
#include "hal/linux/system/worker_thread.hpp"

namespace board {

class BoardDevices {
 public:
  explicit BoardDevices(const BoardFile& file);

  // Empty where everything is open, else what is missing.
  std::string open();
  firmware::Ports ports();
  // As the file has it; where that does not say at which codes a converter saturates, as the driver tells.
  const firmware::ControllerConfiguration& configuration() const { return configuration_; }

  // What the program waits on: descriptors that can change (an interface that came back) are read anew each time.
  static constexpr int kMaxWaits = 4;
  int waits(pollfd (&waits)[kMaxWaits]) const;

  // Drive zero, relay off, whatever the controller thinks. False: one of them was not delivered.
  bool make_safe();
  // When the kernel saw the stop line become active; 0: never.
  uint64_t stop_edge_ns() const { return stop_line_.last_rise_ns(); }
  hal::SystemdWatchdog& systemd() { return systemd_; }
  // Which hardware watchdog guards the board, or why none does, in words.
  const std::string& guard() const { return guard_; }
  // What a person should know of the channels' codes; lines, mostly none.
  const std::string& notes() const { return notes_; }
  void stop_watchdog() { device_watchdog_.disarm(); }
  // Returns when nothing runs beside the loop any more: what runs there works on what the loop owns.
  void wait_for_workers() {
    worker_.wait();
    store_worker_.wait();
  }
  const hal::SocketCan& bus() const { return bus_; }
  const firmware::AssemblyHealth* assembly() const { return can_samples_ ? &can_samples_->health() : nullptr; }

 private:
  std::string open_samples();
  std::string take_ranges();
  std::string open_lines();
  std::string open_watchdog();

  const BoardFile& file_;
  firmware::ControllerConfiguration configuration_;
  hal::LinuxClock clock_;
  hal::SocketCan bus_, sensor_bus_;
  std::optional<firmware::CanSampleSource> can_samples_;
  hal::IioBufferSource iio_samples_;
  hal::IioDirectSource direct_samples_;
  hal::NoDriveOutput no_drive_;
  hal::IioDriveOutput iio_drive_;
  hal::GpioInput stop_line_, sync_line_;
  hal::GpioOutput relay_line_, lamp_line_;
  hal::NoInput no_input_;
  hal::NoOutput no_output_;
  hal::SystemdWatchdog systemd_;
  hal::DeviceWatchdog device_watchdog_;
  hal::BoardWatchdog watchdog_;
  std::string guard_ = "no hardware watchdog", notes_;
  hal::PosixFileOperations files_;
  hal::FileConfigurationStore store_;
  hal::WorkerThread worker_, store_worker_;
};

}  // namespace board
