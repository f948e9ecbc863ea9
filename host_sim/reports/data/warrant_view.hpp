// The board's word on the model, for the pages of a run and of an estimation.
#pragma once
#include <string>

namespace host_sim::reports {

// What the board says of the model beside its numbers: a cause, where, how large, and the next best.
struct WarrantFinding {
  std::string effect, where, unit;  // effect empty: nothing found
  double size = 0.0, std = 0.0;
};
struct WarrantView {
  bool tested = false;  // the data could show what the rig file lacks
  WarrantFinding named, rival;
  double rival_percent = 0.0;  // likelihood gain, of the named cause's
  std::string not_the_cause;   // why the named one is only the nearest; empty: it is the cause
};

}  // namespace host_sim::reports
