// What the sensor check found, in the contract's words.
#pragma once
#include <vector>

#include "../diagnosis.hpp"
#include "sensor_check.hpp"

namespace diagnosis {

// Adds the faults of all records to the causes, and what explains them as well to the ambiguous set.
void report_faults(const std::vector<SensorCheck>& checks, Diagnosis& d);

NamedPlace named_place(const SensorFault& fault);
Cause cause_of(const SensorFault& fault);

// The smallest fault of each motion channel that would have been named; of several records the best.
std::vector<DetectionLimit> fault_limits(const std::vector<SensorCheck>& checks);

}  // namespace diagnosis
