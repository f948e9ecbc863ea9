// Motion channels whose fault is no delay, gain or hum alone: a velocity behind a low-pass is late, and loses what is fast.
#pragma once
#include "../diagnosis.hpp"
#include "../first_screen/rows_say.hpp"

namespace diagnosis {

// Where nothing explains the records, or faults of channels do in part, and channels of one DOF contradict each other beyond chance, without any model of the rig, what judge
// says of the records without those at fault; the fault that describes each best is a cause (sensor_delay, ..), and
// Diagnosis::channels_left_out names them. What it says of all, where that is no better, or where no other channel of the DOF is left.
Diagnosis judged_without_those_at_fault(const Asked& asked, Diagnosis (*judge)(const Asked&));

}  // namespace diagnosis
