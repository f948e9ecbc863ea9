// The board's one file (TOML, docs/board.md): the rig as in a rig file, and how this board measures, drives and talks.
#pragma once
#include <string>
#include <vector>

#include "firmware/can_protocol/load/bus_plan.hpp"
#include "firmware/can_protocol/streams/sensor_frames.hpp"
#include "firmware/rig_controller/settings/controller_configuration.hpp"
#include "hal/linux/gpio/gpio_line.hpp"
#include "hal/linux/iio/iio_channel.hpp"
#include "hal/linux/iio/iio_drive_output.hpp"
#include "hal/rig_file/rig_model.hpp"
#include "hal/rig_file/signal_plan.hpp"

namespace board {

enum class SampleKind { kCan, kIioBuffer, kIioDirect };

struct SampleSettings {
  SampleKind kind = SampleKind::kCan;
  double rate_Hz = 1000.0;
  firmware::SensorWiring wiring = firmware::SensorWiring::k16;  // of sensor frames
  std::string device, trigger;                                  // IIO
  std::vector<hal::IioChannel> channels;                        // IIO
};

struct LineSetting {
  std::string line;  // empty: the board has none
  hal::LineOptions options;
};

enum class DriveKind { kNone, kCan, kIio };

struct BoardFile {
  std::string path;
  rig_file::RigModel rig;
  firmware::ControllerConfiguration controller;
  SampleSettings samples;
  rig_file::SignalRanges told;  // of the motion, before it has been seen
  std::string can_interface = "can0";
  firmware::BitRates bit_rates;  // as the network file sets them
  LineSetting emergency_stop, relay, ready_lamp, sync;
  DriveKind drive = DriveKind::kNone;
  hal::IioDriveOutput::Options iio_drive;
  std::string state_folder;              // configuration store
  std::string watchdog_device = "auto";  // "auto": the hardware's where there is one; "none": systemd's alone
  int watchdog_timeout_s = 5;
  int priority = 80;  // of SCHED_FIFO; 0: an ordinary process
};

// Throws rig_file::RigFileError, which names file, line, key and expectation.
BoardFile read_board_file(const std::string& path);

// Lines for a person: what the file makes the board do.
std::string describe(const BoardFile& board);

}  // namespace board
