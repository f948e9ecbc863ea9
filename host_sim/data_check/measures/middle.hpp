// The middle of a long record, which is enough to compare its channels.
#pragma once
#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

// The record itself, or, where it is longer than that takes, `part`: its 131072 samples in the middle.
const Record& middle_of(const Record& record, Record& part);

}  // namespace host_sim::data_check
