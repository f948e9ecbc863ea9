// See emergency_line.hpp.
#include "firmware/rig_controller/safety/emergency_line.hpp"

namespace firmware {

void EmergencyLine::take_edges() {
  for (int looked_at = 1; looked_at < kEdgesPerLook && line_.next_edge(edge_); ++looked_at) {
  }
}

}  // namespace firmware
