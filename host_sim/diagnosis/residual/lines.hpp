// Single lines in the spectrum of what a model leaves.
#pragma once
#include <vector>

#include "left.hpp"

namespace diagnosis::runs {

constexpr double kLine = 25;            // over the level around: chance makes one in e^25 of a spectrum's bins
constexpr Index kAround = 40;           // bins on either side of a line: the level around it
constexpr double kMainsWidth_Hz = 0.2;  // of the mains' frequency and its multiples
constexpr double kAlone = 9;      // times the power of any other line: harmonics of a drive may fall on the mains too
constexpr double kOneOfThem = 3;  // times the hum of any other channel, each over its own signal: then it is this one's

// Whether a frequency is that of the mains or a multiple, as near as a spectrum of such bins tells.
bool of_mains(double hertz, double bin_Hz);

// Power of a bin over the higher of the levels on its two sides, or over what else is known to be there on average (made; empty:
// nothing) if that is more: a line stands above both, the edge of a band above one.
double over_level_around(const Vec& power, Index bin, const Vec& made = {});

// Highest lines between two bins over the median level around them, or over what the drives' noise makes there if that is
// more; mains left out. `driving`: spectra of what drives the rig.
void highest_lines(const Vec& power, const Vec& by_drives, Index from, Index to, double bin_Hz,
                   const std::vector<Vec>& driving, Left& left);

// The line at 50 or 60 Hz, where there is one. power: of `samples` values, per sample.
Hum hum_in(const Vec& power, size_t samples, double step_s, const std::vector<Vec>& driving);

}  // namespace diagnosis::runs
