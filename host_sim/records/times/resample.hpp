// Records whose samples came at uneven times, as loggers of PCs and buses write them, onto even steps.
#pragma once
#include <string>
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

// The record at rate_Hz, by the polynomial through the six samples around each instant (Lagrange): of a motion of eight
// samples a period it misses 0.1 %, of one of twenty 5e-6. Where rows nearly coincide, through four or two: six would leave
// their range by many times what the two rows differ by. A gap of more than kLongestGap usual steps ends the record; what
// follows is one of its own; parts of fewer than kFewestSamples are left out, and what parts_kept.hpp says of several. What
// was done stands in the notes of the first. A flat top (clipped) stays flat. A command that is held stays so, and a log of
// ticks is read as tick_log.hpp says. A record without times of its own has even steps already. Throws DataFileError where
// the rate is below the record's own (what lies between would fold into the band), or nothing long enough is left.
std::vector<Record> resampled(const Record& record, double rate_Hz);

// How many samples at rate_Hz are in length_s, the first at its start. Throws DataFileError where no memory holds them.
size_t samples_at(const std::string& file, double length_s, double rate_Hz);

constexpr double kLongestGap = 3.5;  // of the usual step: two lost samples, and a late one
constexpr size_t kFewestSamples = 64;

}  // namespace host_sim
