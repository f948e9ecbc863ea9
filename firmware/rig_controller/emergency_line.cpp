// See emergency_line.hpp.
#include "firmware/rig_controller/emergency_line.hpp"

namespace firmware {

void EmergencyLine::take_edges() {
  hal::LineEdge edge;
  for (int looked_at = 1; looked_at < kEdgesPerLook && line_.next_edge(edge); ++looked_at) {
  }
}

}  // namespace firmware
