// One cause at a time beside a model.
#pragma once
#include "beside.hpp"

namespace diagnosis::runs {

constexpr size_t kShortList = 5;  // causes that a search tries first, those that the linearisation promises most of

// Those that the linearisation promises most of, fitted, the best first.
std::vector<Attempt> tried_singles(const Beside& b);

// Where the best are bristles: dry friction in their place, where it does as well. True where the rig's own friction does that and
// brings much: the fit had got stuck (`unstuck`: where it leads); where it brings nothing, nor do they.
bool own_friction_does(const Beside& b, std::vector<Attempt>& singles, State& unstuck);

}  // namespace diagnosis::runs
