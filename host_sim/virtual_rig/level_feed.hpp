// Feeds the virtual rig's samples to the controller on its board of fakes, level by level.
#pragma once
#include "host_sim/virtual_rig/replay_board.hpp"
#include "host_sim/virtual_rig/run_scenario.hpp"

namespace host_sim {

// Of each level the core gets its sample periods and the margin that its filters take off: as much of it as there is
// from the end of settling, the rest from the run-out.
class LevelFeed {
 public:
  LevelFeed(VirtualRig& rig, ReplayBoard& board, ProgressSink& sink) : rig_(rig), board_(board), sink_(sink) {}
  void run();  // to the rig's end, and one more heartbeat and status, which says DONE
  size_t pushed() const { return pushed_; }

 private:
  void begin_level();
  bool wanted() const;
  void take(firmware::RawSample& sample);
  void tell_window() const;

  VirtualRig& rig_;
  ReplayBoard& board_;
  ProgressSink& sink_;
  size_t first_ = 0, end_ = 0;  // samples of the level
  size_t read_ = 0, pushed_ = 0;
};

}  // namespace host_sim
