// How slow a motion can be that the board is to measure, as far as its file tells.
#pragma once
#include <optional>

#include "hal/linux/board/board_file.hpp"

namespace board {

// Octaves from the sample rate down to it (rig_file::SignalRanges): from slowest_Hz, else two octaves below the programme's lowest
// frequency, else below cycle_Hz. Nothing: nobody has said, or a level lets the rig swing by itself or has no lower edge.
std::optional<int> octaves_to_slowest_motion(const BoardFile& board, double slowest_Hz, double cycle_Hz);

}  // namespace board
