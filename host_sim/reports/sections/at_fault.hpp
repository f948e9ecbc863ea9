// What is at fault beside the rig file, in words: sensors, and drives that do not give what the force's channel tells.
#pragma once
#include <cstddef>
#include <string>

namespace host_sim::reports {

// A force that the drive holds between samples is told by its channel, and is no fault of it.
inline constexpr const char* kForceHold = "force_hold";

bool of_channel(const std::string& where);  // "channel force_1_N"

struct AtFault {
  size_t sensors = 0, drives = 0;
  // Counts the cause where it is a fault of a channel; returns whether it is.
  bool add(const std::string& effect, const std::string& where);
  size_t all() const { return sensors + drives; }
};

// "sensors and the drive are at fault": all that are counted; at least one.
std::string at_fault_text(const AtFault& faults);

// "a sensor or a drive is at fault": one of those that are counted; at least one.
std::string one_at_fault_text(const AtFault& possible);

}  // namespace host_sim::reports
