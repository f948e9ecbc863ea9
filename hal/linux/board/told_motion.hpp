// How slow and how fast a motion can be that the board is to measure, as far as its file tells: for the plan of its signals.
#pragma once
#include "hal/linux/board/board_file.hpp"
#include "hal/linux/board/toml_section.hpp"

namespace board {

// slowest_Hz and fastest_Hz of `samples`. Else what the programme's levels can move, some octaves to either side; or, of the slowest, the same
// of cycle_Hz. Unknown where nobody has said, where a level lets the rig swing by itself, and below a band from 0 Hz.
rig_file::SignalRanges told_motion(const Section& samples, const BoardFile& board, double cycle_Hz);

}  // namespace board
