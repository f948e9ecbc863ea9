// The band of a motion, and readings thinned out to what it needs.
#pragma once
#include "../motion/prepared.hpp"

namespace diagnosis::runs {

// About its mean under a Hann taper of unit mean square: what its spectrum shows at high frequencies is not that of the ends.
Vec tapered(const Vec& y);

// Frequency below which nearly all power above the noise floor lies.
double top_frequency(const Vec& reading, double step_s, bool displacement);

// Frequency above which nearly all power of the displacement lies that a velocity (integrals: 1) or an acceleration (2) makes, above the
// noise floor.
double lowest_frequency(const Vec& reading, double step_s, int integrals);

// Frequency from which on an integral of a velocity (integrals: 1) or an acceleration (2) is to be kept: what it loses of the motion below
// and what it keeps of the noise above are the least together.
double slowest_above_noise(const Vec& reading, double step_s, int integrals);

// Low-pass of windowed-sinc shape for thinning out by `by`; ends are left out (3 by samples each).
Vec thinned(const Vec& y, int by);

}  // namespace diagnosis::runs
