// The emergency-stop line as the controller looks at it. A look takes the edges that wait and then the level, each
// once; nothing is remembered from one look to the next, so there is no order of level and edge that hides a press:
// what comes after the level has been read leaves its edge, or its level, to the next look.
//
// Either direction of edge tells of a press: an edge has the pressed level on one of its sides. (Linux names an edge
// after the level that it finds some microseconds later, so a short press may be told as a release alone.)
#pragma once
#include "hal/interface/digital_line.hpp"

namespace firmware {

class EmergencyLine {
 public:
  explicit EmergencyLine(hal::DigitalInput& line) : line_(line) {}

  // True where the line is pressed now or has been since the last look.
  bool pressed() {
    const bool changed = line_.next_edge(edge_);
    if (changed) take_edges();
    return line_.active() || changed;
  }

 private:
  void take_edges();
  // More edges than that in one look: a line that chatters, which counts as pressed like any edge. The rest waits.
  static constexpr int kEdgesPerLook = 16;
  hal::DigitalInput& line_;
  hal::LineEdge edge_;  // the last one: that there was one is all that counts
};

}  // namespace firmware
