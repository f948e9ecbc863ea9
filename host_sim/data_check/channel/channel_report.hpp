// All that one channel says about itself.
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {

// The report of record.channels[index]. all: the statistics of every channel of the record. model: nothing where there is no rig file.
ChannelReport report_of(const Record& record, const std::vector<Statistics>& all, size_t index,
                        const rig_file::RigModel* model);

}  // namespace host_sim::data_check
