#include "unseen_windows.hpp"

#include <algorithm>

#include "host_sim/vocabulary/held_in_place.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kUnseenShare = 0.3;  // of a record: its end
constexpr Index kFewest = 12;         // samples of a run
// Where no spring holds a DOF in its place the run starts anew that often; where it runs on, after a period of what is off its line.
constexpr double kRestart_s = 1;

double restart_s(const Prepared& p) {
  const bool runs_on = std::any_of(p.traces.begin(), p.traces.end(), [](const MotionTrace& t) { return t.travels; });
  return runs_on ? std::max(kRestart_s, p.period_s) : kRestart_s;
}

// Where the record's end moves too little to be judged by: the windows that were kept apart instead of it.
std::vector<Window> kept_apart(const State& state, size_t record) {
  std::vector<Window> list;
  for (const Window& w : state.unseen)
    if (w.record == record) list.push_back(w);
  return list;
}

std::vector<Window> consecutive(const State& state, size_t record, Index from, Index to, Index length) {
  std::vector<Window> list;
  for (; from + kFewest <= to; from += length) {
    Window w;
    w.record = record, w.from = from, w.length = std::min(length, to - from);
    // the state at its start: as the first window of a short fit tells, where there is one
    for (const Window& u : state.unseen)
      if (u.record == record && u.from == from && u.state.size()) w.state = u.state;
    list.push_back(w);
  }
  return list;
}

}  // namespace

Unseen unseen_windows(const Task& task, const State& state, size_t record, bool massless) {
  const Prepared& p = task.records[record];
  const bool apart = task.training < task.records.size(), pushed = forced(task.records) && !massless;
  Unseen unseen{moving_span(p, pushed), !apart && ends_steadily(p, pushed, kUnseenShare), {}};
  if (unseen.spread) unseen.windows = kept_apart(state, record);
  if (!unseen.windows.empty()) return unseen;
  const Index to = unseen.moving.to, all = to - unseen.moving.from;
  const Index from =
      unseen.moving.from + (apart ? 0 : static_cast<Index>((1 - kUnseenShare) * static_cast<double>(all)));
  const bool one = massless || vocabulary::held_in_place(task.system.rig);
  const Index length = one ? to - from : std::max(kFewest, static_cast<Index>(restart_s(p) / p.step_s));
  unseen.windows = consecutive(state, record, from, to, length);
  return unseen;
}

}  // namespace diagnosis::runs
