// A single force that is turned over against the motions: told by its work (work.hpp) or by the rig file (rig_balance.hpp).
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// A single force that is turned over in some records and not in others is a fault: a sign is of the cable, not of a record. One that is four
// times shorter than one that says it need not say it too.
void require_one_sign(Report& report);

// What is said of a single force that is turned over.
constexpr const char* kSignIsChanged = "change the sign of the column (estimate and diagnose do, unless told --anyway)";
// Changes the sign of a single force that is turned over, in all records. True where there is one.
bool turn_over(Report report, std::vector<Record>& records);

}  // namespace host_sim::data_check
