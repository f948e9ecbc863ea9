// Residuals of a model's windows.
#pragma once
#include <vector>

#include "left.hpp"

namespace diagnosis::runs {

// What the model leaves of each channel, windows end to end, and what noise of the drives would make of it.
struct Leftovers {
  std::vector<std::vector<double>> rows, pushed;
  std::vector<std::vector<double>>
      steps;  // what a channel's steps lose of the simulated motion; empty: it has none, or no mass moves
  std::vector<size_t> ends;  // of each record's part of the rows
  bool massless = false;
  std::vector<std::vector<double>> rows_by_record(size_t channel) const;  // none of a record without windows
};

// False where a run does not stay finite.
bool leave_over(const System& system, const std::vector<Prepared>& records, const State& state, Leftovers& out);

// Power of each bin, as white noise has its variance.
Vec spectrum(const std::vector<double>& rows);

}  // namespace diagnosis::runs
