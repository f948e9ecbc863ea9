// See emergency_line.hpp.
#include "firmware/rig_controller/emergency_line.hpp"

namespace firmware {

bool EmergencyLine::pressed() {
  bool was_pressed = false;
  hal::LineEdge edge;
  for (int looked_at = 0; looked_at < kEdgesPerLook && line_.next_edge(edge); ++looked_at) was_pressed = true;
  const bool is_pressed = line_.active();
  return was_pressed || is_pressed;
}

}  // namespace firmware
