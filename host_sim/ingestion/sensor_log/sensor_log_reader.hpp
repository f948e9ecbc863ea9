// CAN logs of the sensor frames (docs/can_protocol.md), as `candump -L` or `candump -ta`, `-tA`, `-tz` write them, or
// Vector's tools as .asc: raw codes to SI units.
//
// The calibration of a channel is the rig file's [[channel]] with unit_per_code, or else what the controller on the bus
// says of it (frames `scaling` and `range`). A channel without one is not read. Every sample must be whole: all frames
// of its sequence number, no number left out, unless the record is to be interpolated (ReadingOptions::resample_Hz): its times are
// then those of the sequence numbers. The sample period is that of the whole log; the record starts at 0.
#pragma once
#include <string>
#include <string_view>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/columns/reading_options.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Extension .log or .candump, or a first line that is a frame or the head of Vector's .asc log. (Other programs write
// tables of numbers as .asc.)
bool is_sensor_log(const std::string& path, std::string_view content);

// Throws DataFileError with the line. Lines that are no frame, and frames of others, are passed over.
Record parse_sensor_log(std::string_view content, const std::string& file, const rig_file::RigModel& model,
                        const ReadingOptions& options = {});

}  // namespace host_sim
