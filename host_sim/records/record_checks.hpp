// What holds for measured data of any format, once it is in memory.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// The channel of that name, without values. Throws DataFileError (with the line) where the rig has no use for the name.
Channel channel_of_name(const std::string& name, const rig_file::RigModel& model, const std::string& file, size_t line);

// Sets start and sample period from the sample times. Sample i stands on line first_line + i; a step that is off by
// more than 1 % from the usual (median) step throws DataFileError with its line.
void set_time_base(const std::vector<double>& time_s, size_t first_line, Record& record);

// Every DOF of the rig must have a displacement, velocity or acceleration (and so must a moving base): else
// DataFileError.
void require_motion_channels(const Record& record, const rig_file::RigModel& model);

// Several records of one rig must have the same channels and the same sample period: else DataFileError.
void require_same_channels(const std::vector<Record>& records);

}  // namespace host_sim
