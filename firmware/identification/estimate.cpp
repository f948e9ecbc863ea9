#include "firmware/identification/estimate.hpp"

#include <new>

namespace firmware {

Estimates::Estimates() = default;

void clear(Warrant& warrant) { warrant = Warrant{}; }

// In place: beside it a copy would be the largest part of the stack.
void clear(Estimates& estimates) { new (&estimates) Estimates; }

}  // namespace firmware
