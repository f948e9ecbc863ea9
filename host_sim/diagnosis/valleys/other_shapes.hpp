// Causes whose fit got stuck, from other shapes.
#pragma once
#include <optional>

#include "../trial/attempt.hpp"

namespace diagnosis::runs {

// Friction that sticks makes valleys of the error: where a fit ends hangs on the shape that it started with. Where the slopes still
// promise a fall at its end (`reached`) it starts again beside the model before (`beside`), each shape in turn on either side of what
// was reached. The lowest of these, where it is lower.
std::optional<Attempt> from_other_shapes(const Task& task, const State& beside,
                                         const std::vector<Candidate>& candidates, const State& reached);

}  // namespace diagnosis::runs
