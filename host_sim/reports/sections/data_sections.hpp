// The sections that say how far the data and the model can be trusted.
#pragma once
#include <optional>

#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/reports/page/page.hpp"

namespace host_sim::reports {

// Channels with rms, noise and resolution, and what the check of the data found. Nothing: no section.
void add_data_check(Page& page, const std::optional<data_check::Report>& check);

// What the board says of the model: cause, place, size and the next best. Nothing: no section.
void add_warrant(Page& page, const std::optional<WarrantView>& warrant);

}  // namespace host_sim::reports
