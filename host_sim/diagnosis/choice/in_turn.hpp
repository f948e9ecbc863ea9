// Causes named one after the other.
#pragma once
#include "choice.hpp"

namespace diagnosis::runs {

// Names causes one after the other, over the windows of choice.final; worth: as in round_of(). progress: called with the share done.
void name_in_turn(const Task& task, double worth, Choice& choice, const std::function<void(double)>& progress);

}  // namespace diagnosis::runs
