// What candidates are tried beside.
#pragma once
#include "attempt.hpp"

namespace diagnosis::runs {

// A model and what it leaves, with the candidates beside it as screened; `noise`: the share of what is left that looks like noise.
struct Beside {
  const Task& task;
  const State& now;
  size_t already;  // causes named before
  double noise;
  const std::vector<Candidate>& all;
  const Screen& screen;
};

}  // namespace diagnosis::runs
