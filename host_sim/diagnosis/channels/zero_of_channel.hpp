// Constant forces that are one channel's zero.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// A displacement that reads d too much looks like a constant force -k d in every spring at its DOF. Where such forces are named in all
// of them, two at least, and agree about d, the one number is told in their place: sensor_offset. (Where one spring alone holds the
// DOF the two are the same; the advice says so.)
void name_zeros(const Task& task, Diagnosis& d);

}  // namespace diagnosis::runs
