// Feeds the virtual rig's samples to the core, level by level.
#pragma once
#include "host_sim/virtual_rig/run_scenario.hpp"

namespace host_sim {

// Of each level the core gets its sample periods and the margin that its filters take off: as much of it as there is
// from the end of settling, the rest from the run-out.
class LevelFeed {
 public:
  LevelFeed(VirtualRig& rig, firmware::EstimatorCore& core, ProgressSink& sink) : rig_(rig), core_(core), sink_(sink) {}
  void run();  // to the rig's end
  size_t pushed() const { return pushed_; }

 private:
  void begin_level();
  bool wanted() const;
  void push(firmware::RawSample& sample);
  void tell(uint64_t now_ns, bool window);

  VirtualRig& rig_;
  firmware::EstimatorCore& core_;
  ProgressSink& sink_;
  size_t first_ = 0, end_ = 0;  // samples of the level
  size_t read_ = 0, pushed_ = 0;
};

}  // namespace host_sim
