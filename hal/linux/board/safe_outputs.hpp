// Every output of a board in its safe state: relay off, drive zero, ready lamp off.
#pragma once
#include <string>
#include <vector>

#include "hal/linux/board/board_file.hpp"
#include "hal/linux/can/socket_can.hpp"

namespace board {

// Sends the drive command "zero, stopped" of a node; waits up to 50 ms for room in the queue. False: it was not taken.
bool send_zero_drive(hal::SocketCan& bus, int node);

// For when the program that drove them is gone: opens each output that the file names and brings it to its safe state,
// whatever becomes of the others. Returns what could not be done, in words; empty: all of them are safe.
std::vector<std::string> bring_outputs_to_safe_state(const BoardFile& file);

// `rig_controller --safe FILE`. Where all outputs are safe the hardware watchdog is disarmed too; where one is not, it
// stays as it is: armed by the program that died, it resets the board. The exit status; faults go to standard error.
int make_board_safe(const std::string& path);

}  // namespace board
