// What only counts where every record says it.
#pragma once
#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// A cable in the wrong place is there in every record; what one record alone says is the rig's doing, and is taken out.
void keep_what_all_records_say(const char* kind, Report& report);

}  // namespace host_sim::data_check
