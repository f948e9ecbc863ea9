// Two causes at a time beside a model.
#pragma once
#include "beside.hpp"

namespace diagnosis::runs {

constexpr size_t kPairs = 40;  // that are screened

// Those that the linearisation promises most of, fitted; single: the best cause alone, which two have to beat; nullptr: none.
std::vector<Attempt> tried_pairs(const Beside& b, const Attempt* single);

}  // namespace diagnosis::runs
