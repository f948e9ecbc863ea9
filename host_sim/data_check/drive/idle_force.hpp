// A force that reads one exact value while the motion that it should make gains energy.
#pragma once
#include <optional>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// work, a doubt: over a tenth of the record and more all forces read one value each, to the last digit, do no work on the net motion (they
// are nought or push against it), and the motion grows (growth.hpp) beyond all that it was on that stretch before, to a twentieth of what it
// has in the record at least. A release, a blow and a coast-down lose energy, and beats gain no more than they had; a command that is held at
// a value does the work. Of one DOF, with a base that stands still: energy may go from mass to mass.
std::optional<Finding> find_idle_force(const Record& record);

}  // namespace host_sim::data_check
