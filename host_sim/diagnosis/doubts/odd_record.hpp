// One record of several that is another rig's: another specimen, a stop that it alone reaches, a mounting that has changed.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Of three records or more the one without which the others agree best: fitted to them alone, a free run misses a twentieth of its motion
// beyond noise, and three times as much as of any other. Nothing where no record is so, or nothing is followed.
std::optional<OddRecord> odd_record(const Task& task, const Choice& choice);

// A rig that explains all records but one explains them not; every number may be bent by it.
void say_odd_record(const Task& task, const Choice& choice, Diagnosis& d);

}  // namespace diagnosis::runs
