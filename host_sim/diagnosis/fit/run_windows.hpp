// Windows of one model, run side by side.
#pragma once
#include "evaluator.hpp"
#include "in_parallel.hpp"

namespace diagnosis::runs {

// take(window's index, its run, lane) for every window, in any order; the run is the lane's, and may be changed. False where one does
// not stay finite: the rest is left out then.
template <typename Take>
bool run_windows(Evaluator& evaluator, const std::vector<Window>& windows, bool slopes, const Take& take) {
  std::vector<WindowRun> runs(lanes());
  std::atomic<bool> finite{true};
  in_parallel(windows.size(), [&](size_t i, size_t lane) {
    if (finite && !evaluator.run(windows[i], slopes, false, runs[lane], lane)) finite = false;
    if (finite) take(i, runs[lane], lane);
  });
  return finite;
}

}  // namespace diagnosis::runs
