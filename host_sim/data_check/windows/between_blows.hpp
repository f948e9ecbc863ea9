// Stretches of windows in which nothing strikes the rig.
#pragma once
#include <vector>

#include "host_sim/data_check/windows/energy.hpp"

namespace host_sim::data_check {

// From where to where windows show no blow; the window behind the last of them does.
struct Span {
  size_t from = 0, to = 0;
  bool clipped = false;  // up to there
};

std::vector<Span> between_blows(const Windows& energy);

// What is clipped of a decay is its beginning, and it begins a quarter of a period behind that: what was clipped dies away first, and
// an amplifier recovers. The windows before are no part of the motion that is seen.
void begin_behind_clipping(const Record& record, size_t hop, std::vector<Span>& spans, Windows& energy);

}  // namespace host_sim::data_check
