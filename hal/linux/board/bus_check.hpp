// Whether the rig of a board's file fits its bus: the frames that it and its sensors send, from the frame table, against
// the bit rate.
#pragma once
#include <string>

#include "hal/linux/board/board_file.hpp"

namespace board {

struct BusCheck {
  bool fits = true;     // at most 80 % of the bus with the most stuff bits possible; a virtual bus takes everything
  std::string load;     // "68 % of 1000 kbit/s at worst: sensor_motion_24 41 %, drive 13 %, ..."
  std::string instead;  // where it does not fit: what would
};
BusCheck check_bus(const BoardFile& file);

// Where the bus has no room for the estimates as floats, and the file does not ask for them, they are left out.
void fit_float_estimates(BoardFile& file);

// Throws rig_file::RigFileError at [can] where it does not fit.
void require_bus(const BoardFile& file);

}  // namespace board
