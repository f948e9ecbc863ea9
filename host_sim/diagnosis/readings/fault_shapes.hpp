// What a channel's faults add to its reading, per unit: the shapes they have over a window.
#pragma once
#include "../motion/prepared.hpp"

namespace diagnosis::runs {

// Slope in time of a row, five points inside, fewer at the ends.
Vec slope_in_time(const Vec& row, double step_s);

// A hum of amplitude one, its phase counted from the record's start: its cosine or its sine.
Vec hum_wave(const Prepared& record, Index from, Index length, double frequency_Hz, bool cosine);

}  // namespace diagnosis::runs
