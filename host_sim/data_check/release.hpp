// What a record shows before its rig is let go: a hand that leads it, a pull that is held, a blow that nobody measured.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// Samples at the start of a record without a force and without a moving base that are no free decay. Nothing but a decay follows what
// it calls its start: the energy of the motion, as mean square of the rates over one period, never rises again by more than a fifth,
// falls to a quarter, and is seen for at least four periods. 0 where the record begins with its decay, or where there is none such
// (ambient vibration, a rig that drives itself).
size_t samples_before_release(const Record& record);

// Tells of them.
std::optional<Finding> find_release(const Record& record);

// Takes them off the records; one sentence for each record that loses any.
std::vector<std::string> begin_at_release(std::vector<Record>& records);

}  // namespace host_sim::data_check
