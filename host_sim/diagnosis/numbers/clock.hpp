// Numbers that are all off by one factor, as a wrong clock makes them.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Times that are s times too short make of accelerations springs that are s^2 times as stiff and of displacements masses of 1 / s^2, and dampers of s and
// 1 / s. So where all known springs, two or more, or all known masses are named as wrong by one factor that is no slip of a unit, that is said, and no
// damper is vouched for.
void say_clock(const Task& task, Diagnosis& d);

}  // namespace diagnosis::runs
