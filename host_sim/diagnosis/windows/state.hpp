// A model and the windows that it is fitted to; and whose they are.
#pragma once
#include "../fit/fit.hpp"
#include "windows.hpp"

namespace diagnosis::runs {

// The rig file and its records; `training` of them may be fitted, the others are unseen (where there are none, the last 30 % of each).
struct Task {
  const System& system;
  const std::vector<Prepared>& records;
  size_t training;
};

// Everything a fit needs, and what it left.
struct State {
  Model model;
  std::vector<Window> seen, unseen;
  Fitted fit, unseen_fit;
  Vec noise = {};  // of each channel, mean square, as left_by() has it; empty: not asked
};

}  // namespace diagnosis::runs
