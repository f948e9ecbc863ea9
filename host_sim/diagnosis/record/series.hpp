// Of one value per sample.
#pragma once
#include "fourier.hpp"

namespace diagnosis {

double rms_about_mean(const Series& y);
// Of the straight line that fits best: its slope, per sample, and the sum of squares of what is off it.
double slope_of_line(const Series& y);
double square_off_line(const Series& y);
// A place that travels: on its line it goes kTravels times as far as it is off it, rms. A table or a mass on a spring swings about a
// place; a shaft runs on, and its angle's size says nothing of the forces on it.
constexpr double kTravels = 10;
bool travels(const Series& y);

// Running integral from nought, exact for cubics but at the ends.
Series integral(const Series& y, double period_s);

}  // namespace diagnosis
