// The way of a model and its windows' states to the least cost.
#pragma once
#include "evaluator.hpp"

namespace diagnosis::runs {

// Moves the model's free numbers and the windows' states; `only_states` leaves the numbers alone. The weights that the channels
// have in the end; none where it leads nowhere. passes: that it took, with slopes.
Vec descended(const System& system, const std::vector<Prepared>& records, Model& model, std::vector<Window>& windows,
              int iterations, bool only_states, size_t& passes);

}  // namespace diagnosis::runs
