// Pieces that both pages use.
#pragma once
#include <string>
#include <vector>

#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/reports/page/page.hpp"

namespace host_sim::reports {

constexpr size_t kColumns = 400;      // of an envelope: about the pixels of a picture
constexpr size_t kBandColumns = 160;  // of a band, whose edges are for the eye only
constexpr double kDetailCycles = 12;  // mean periods in a detail

std::string facts_html(const std::vector<std::string>& facts);

// "20.01 <span>19.9 … 20.1</span>", to the digits that the interval supports.
std::string interval_html(const Interval& interval);

// Significant digits that a value with an interval of this width deserves: 3 to 7.
int digits_for(const Interval& interval);

// What a page says of the pictures of waveforms, behind the rig that they show.
std::string how_simulated(bool free);

// Of a power density: "m" -> "m^2/Hz", "m/s^2" -> "(m/s^2)^2/Hz".
std::string density_unit(const std::string& unit);

// A badge for a status word ("VALID" is good, the rest is a warning).
std::string status_html(const std::string& status);

}  // namespace host_sim::reports
