// What a line at the mains' frequency makes of the estimation.
#pragma once
#include <string>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// The mean square of a line over that of all else that stands above the channel's noise (30 times the median of its spectrum), both
// differentiated as often as the estimation does it with the channel: twice for a displacement alone, in which 60 Hz count for 900 times as
// much as 2 Hz. 0 where a force or the base has a tenth of that line beside its own rms, and more: it may drive the rig there.
double hum_share(const Record& record, const Channel& channel, double line_amplitude, double line_Hz,
                 int differentiated);

constexpr double kHumSpoils = 0.02;  // of the mean square, as spikes do

// What is said of the motion channels whose hum is a doubt, of all records; empty: there are none.
std::string spoilt_by_hum(const Report& report);

}  // namespace host_sim::data_check
