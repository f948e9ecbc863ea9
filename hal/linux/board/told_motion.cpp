#include "hal/linux/board/told_motion.hpp"

#include <algorithm>
#include <cmath>

namespace board {
namespace {

// Links that rattle or stick move at a half, a third and a quarter of a drive's frequency too, and at many times of it.
constexpr double kSubharmonic = 4.0, kHarmonic = 8.0;

struct Frequencies {
  double lowest_Hz = 0.0, highest_Hz = 0.0;  // 0: not known
};

Frequencies frequencies_of(const firmware::ExcitationProgramme& programme, double rate_Hz) {
  if (programme.level_count == 0) return {};
  Frequencies all{rate_Hz, 0.0};
  for (int i = 0; i < programme.level_count; ++i) {
    const firmware::ExcitationLevel& level = programme.levels[i];
    if (level.kind == firmware::ExcitationKind::kFreeDecay) return {};
    const bool band = level.kind == firmware::ExcitationKind::kRandomBand;
    const double cycle_Hz = std::ldexp(rate_Hz, -32);
    all.lowest_Hz = std::min(all.lowest_Hz, level.phase_step * cycle_Hz);
    all.highest_Hz = std::max(all.highest_Hz, (band ? level.high_phase_step : level.phase_step) * cycle_Hz);
  }
  return all;
}

}  // namespace

rig_file::SignalRanges told_motion(const Section& samples, const BoardFile& board, double cycle_Hz) {
  const double rate_Hz = board.samples.rate_Hz;
  Frequencies driven = frequencies_of(board.controller.programme, rate_Hz);
  if (board.controller.programme.level_count == 0) driven.lowest_Hz = cycle_Hz;
  const double slowest_Hz = samples.number("slowest_Hz", driven.lowest_Hz / kSubharmonic, 0.001, 10000.0);
  rig_file::SignalRanges told;
  told.fastest_Hz = samples.number("fastest_Hz", driven.highest_Hz * kHarmonic, 0.001, 10000.0);
  if (samples.has("slowest_Hz") && samples.has("fastest_Hz") && slowest_Hz > told.fastest_Hz)
    samples.refuse("slowest_Hz", "is above fastest_Hz, expected it below");
  if (slowest_Hz > 0.0)
    told.octaves_to_slowest_motion = static_cast<int>(std::ceil(std::log2(rate_Hz / slowest_Hz) - 1e-6));
  return told;
}

}  // namespace board
