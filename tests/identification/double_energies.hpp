// The energy equations in double precision from the same codes that the core gets, written from docs/design.md and
// docs/estimation.md: trapezoids with end corrections over samples, nothing of the core's arithmetic.
#pragma once
#include "firmware/acquisition/raw_sample.hpp"
#include "tests/identification/double_reference.hpp"

namespace reference {

// Rigs whose every DOF has all four quantities measured, of masses, springs, dampers and friction.
// batch_samples: lengths of the windows, one after the other, the first one beginning at the level's sample `first`.
LevelEnergies energies(const firmware::CoreConfiguration& configuration, const std::vector<firmware::RawSample>& codes,
                       bool periodic, const std::vector<uint32_t>& batch_samples, size_t first);

}  // namespace reference
