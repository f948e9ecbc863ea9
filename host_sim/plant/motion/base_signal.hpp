// The motion of the base that a record shows.
#pragma once
#include "host_sim/plant/instruments/signal.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Its displacement, or else its velocity integrated, rid of white noise (smoothed.hpp): the slope of a noisy displacement is
// all noise, in which friction turns round many times a sample. Throws PlantError where the record has neither.
SignalPtr base_signal(const Record& record, double start_s, Interpolation interpolation);

}  // namespace host_sim
