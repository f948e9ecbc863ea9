// Where a record shows its rig decay freely.
#pragma once
#include <vector>

#include "host_sim/data_check/decay/decay_span.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

// The free decays of a record without a force and without a moving base. The energy of the motion is taken as the mean
// square of the rates over one period. Where it rises fourfold within a period the rig was hit. Between such rises,
// nothing but a decay follows what is called its start: the energy never rises again by more than a fifth, falls to a
// quarter, and is seen for at least four periods. Of a decay that does not begin with the record one period more is
// lost (half of one where it lasts fewer than 16). A decay whose start is clipped begins behind it. What follows a wrong start is a free decay still: of beats with a
// hidden mass some are lost. Empty where there is none such, or where three quarters of the loud part of the record are
// none (ambient vibration, a rig that drives itself). Beside one that is long enough neither noise before a trigger nor what has
// too few samples is one. What turns or rolls one way has no period: coasting.hpp.
std::vector<DecaySpan> free_decays(const Record& record);

// Those that tell of the rig, and the others: of noise before a blow, and too short ones beside one that is long enough.
struct SortedDecays {
  std::vector<DecaySpan> kept, dropped;
};

SortedDecays sorted_decays(const Record& record);

}  // namespace host_sim::data_check
