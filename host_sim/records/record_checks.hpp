// What holds for measured data of any format, once it is in memory.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// A force, or a channel of the moving base.
bool is_drive(const Channel& channel);
// One that changes, or a command that is held at one value other than 0. A measured force that never changes is none, as the column of
// noughts that comes with a free decay: its sensor's zero is not known.
bool drives(const Channel& channel);
bool has_drive(const Record& record);
bool any_has_drive(const std::vector<Record>& records);

// The channel of that name, without values. Throws DataFileError (with the line) where the rig has no use for the name;
// a rig without DOFs stands for "no rig file" and has use for every channel.
Channel channel_of_name(const std::string& name, const rig_file::RigModel& model, const std::string& file, size_t line);

// Times beyond eleven days (seconds since 1970) are counted from the first, with a note.
// Sets start, sample period and jitter from the sample times; line_of(i) is where sample i stands. A step that is off by
// more than 1 % from the usual (median) step throws DataFileError with its line, unless all times are those of even
// steps rounded to their last decimal, as milliseconds are at 1024 Hz (even_times).
void set_time_base(const std::vector<double>& time_s, const std::function<size_t(size_t)>& line_of, Record& record);

// Keeps the times as they are, for a record that is to be resampled. Throws DataFileError where they do not rise.
void keep_times(const std::vector<double>& time_s, const std::function<size_t(size_t)>& line_of, Record& record);

// Every DOF of the rig (none where there is no rig file) must have a displacement, velocity or acceleration (and so must a moving base): else
// DataFileError.
void require_motion_channels(const Record& record, const rig_file::RigModel& model);

// The channels of a record that the other lacks.
std::vector<const Channel*> channels_beyond(const Record& record, const Record& other);

// To a thousandth.
bool same_period(const Record& a, const Record& b);

// Several records of one rig must have the same channels and the same sample period: else DataFileError.
void require_same_channels(const std::vector<Record>& records);
void require_same_channels(const Record& first, const std::vector<Record>& records);
// Brings the channels of records that have those of the first into its order: files list them as they please.
void order_channels_as(const Record& first, std::vector<Record>& records);

}  // namespace host_sim
