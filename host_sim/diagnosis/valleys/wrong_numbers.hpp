// Masses and springs that a rig file has wrong by so much that it follows its recording over no period of its motion.
#pragma once
#include "../choice/choice.hpp"

namespace diagnosis::runs {

// kSurely: each of them is off by half or more, and beside them nothing but noise is left.
enum class Wrong { kNo, kPerhaps, kSurely };

// Where the rig as given does not follow one period of the motion and nothing is named yet: frees all its masses and springs,
// from what the equations of motion make of the measured motion, and where that is not enough puts springs and dampers between
// all DOFs. Where the rig then follows, numbers that are off beyond chance and calibration are named (a force's gain where all
// are off by one factor) and choice is that of the rig with them. A rig that no force drives has no scale: its masses stay.
Wrong name_wrong_numbers(const Task& task, Choice& choice);

}  // namespace diagnosis::runs
