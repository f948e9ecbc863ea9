// A mode that the rig file lacks, where no search from the rig as given finds it.
#pragma once
#include "../choice/choice.hpp"

namespace diagnosis::runs {

// A mode inside the motion's band splits the rig's own: from numbers fitted without it no small step leads there. The balance of
// forces over frequency shows it, with all numbers beside it; it is named where windows follow from there. False: none is.
bool name_hidden_mode(const Task& task, Choice& choice);

}  // namespace diagnosis::runs
