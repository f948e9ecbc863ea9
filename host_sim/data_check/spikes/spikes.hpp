// Single values that do not belong: spikes of one to three samples, and stretches where a channel drops out.
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {

struct KnownChannel {
  const Channel* channel = nullptr;
  const Statistics* statistics = nullptr;
};

struct Neighbours {
  const Record& record;    // that the channel is of: the motion of a force's DOF tells whether a blow acted
  int differentiated = 0;  // how often the estimation differentiates the channel: 2 for a displacement alone
  // Of an acceleration or force: what one sample of 1 changes the velocity by (the sample period, over the mass), and
  // what the velocity spans; 0 where that is not known.
  double velocity_step = 0.0, velocity_range = 0.0;
  std::vector<KnownChannel> forces;  // of the record: an acceleration under a blow is no fault
};

// A spike: one to three samples off both what stands before and what stands behind them, alone, by more than 8 standard
// deviations of the same measure nearby (less than one in 10^10 samples of Gaussian noise), by 4 times what 95 % of the
// whole record is off (so that a record of few samples a period has none), and 2 % of the range.
// Where the samples beside it swing as fast, it belongs to a ringing of a few samples a period (misfit.hpp), and is none.
// Displacement and velocity cannot do that. An acceleration can, at an impact, and a force, at a hammer's blow: those
// are named where they would have changed the velocity by more than 5 times all that it spans, or are beyond any range
// (1000 times the rest for an acceleration, a million times for a force), or a single sample of an acceleration that is
// 1.5 times what 90 % of its samples span while no force strikes; or where the motion of the force's DOF shows less than half of the
// momentum that the blows together should have brought, by four deviations (answered.hpp): then none of them acted.
// A dropout: four and more equal values of a displacement or velocity, entered and left by jumps.
// What does no harm and is below a tenth of the range is not said. A fault where they raise the mean square of what the estimation makes of the channel
// by more than 2 %, or that of a velocity or acceleration that was computed from it (carried.hpp): all channels of a DOF enter its equation.
std::optional<Finding> find_spikes(const Channel& channel, const Statistics& statistics, const Neighbours& neighbours);

}  // namespace host_sim::data_check
