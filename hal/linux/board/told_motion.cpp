#include "hal/linux/board/told_motion.hpp"

#include <algorithm>
#include <cmath>

namespace board {
namespace {

// What a drive moves at its own frequency, links that rattle or stick move at a half, a third and a quarter of it too.
constexpr double kSubharmonic = 4.0;

// Of all levels; 0: not known.
double lowest_frequency_Hz(const firmware::ExcitationProgramme& programme, double rate_Hz) {
  double lowest_Hz = rate_Hz;
  for (int i = 0; i < programme.level_count; ++i) {
    const firmware::ExcitationLevel& level = programme.levels[i];
    if (level.kind == firmware::ExcitationKind::kFreeDecay) return 0.0;
    lowest_Hz = std::min(lowest_Hz, std::ldexp(level.phase_step * rate_Hz, -32));
  }
  return programme.level_count == 0 ? 0.0 : lowest_Hz;
}

}  // namespace

std::optional<int> octaves_to_slowest_motion(const BoardFile& board, double slowest_Hz, double cycle_Hz) {
  const double rate_Hz = board.samples.rate_Hz;
  if (slowest_Hz == 0.0) {
    const bool drives = board.controller.programme.level_count > 0;
    slowest_Hz = (drives ? lowest_frequency_Hz(board.controller.programme, rate_Hz) : cycle_Hz) / kSubharmonic;
  }
  if (!(slowest_Hz > 0.0)) return std::nullopt;
  return static_cast<int>(std::ceil(std::log2(rate_Hz / slowest_Hz) - 1e-6));
}

}  // namespace board
