// Faults of channels in the units of the vocabulary: what a probe's force is of one, and which gains are slips.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "firmware/identification/estimate.hpp"
#include "firmware/warrant/probes/probe.hpp"

namespace firmware {

constexpr int kSlipPercent = 10;       // within which a gain is that of a slip
constexpr int kRoughSlipPercent = 50;  // beside noise, or where no other channel measures the gain

// The known or estimated coefficient of a kind at a place; 0: there is none.
Scaled coefficient_at(const CoreConfiguration& configuration, const Estimates& estimates, TermKind kind, int place);

// What a unit of the probe's force is of a channel fault: seconds, or the share of what the channel says that is not so.
Scaled fault_unit(const CoreConfiguration& configuration, const Estimates& estimates, const Probe& probe,
                  const Place& place);

// A gain that is none: a channel turned over, or in another unit.
Cause slip_of(const Scaled& gain, Cause otherwise, int percent = kSlipPercent);

}  // namespace firmware
