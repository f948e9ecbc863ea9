// The loop around RigController on a board.
#pragma once
#include "hal/linux/board/board_devices.hpp"

namespace board {

struct RunOptions {
  bool until_done = false;
  double seconds = 0.0;  // 0: until stopped
};

// Runs until SIGTERM, SIGINT, SIGHUP or SIGQUIT, or as the options say; leaves the drive at zero and the relay off. False: the loop
// could not be set up, or that was not delivered. What happened is told on standard error.
bool run(const BoardFile& file, BoardDevices& devices, const RunOptions& options);

}  // namespace board
