// What to measure next, from what limits the estimates: one advice, the most pressing first.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "firmware/identification/rows/rows.hpp"

namespace firmware {

// Needs values, statuses and skew in estimates; fills advice, advice_index and advice_frequency_Hz.
void give_advice(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                 Estimates& estimates);

}  // namespace firmware
