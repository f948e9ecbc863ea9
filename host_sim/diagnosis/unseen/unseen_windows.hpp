// The stretches of a record that free runs are scored on.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

struct Unseen {
  Span moving;  // of the record
  // Windows from all over the record are held against its motion: many of them are as steady as its end, and noise over noise says
  // nothing.
  bool spread = false;
  std::vector<Window> windows;
};

// Of a record that no fit has seen all, of another the last part.
Unseen unseen_windows(const Task& task, const State& state, size_t record, bool massless);

}  // namespace diagnosis::runs
