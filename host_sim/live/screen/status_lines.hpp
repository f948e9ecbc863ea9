// The lines above and below the table: the wire, the node, its diagnosis, what happened.
#pragma once
#include <cstdint>
#include <vector>

#include "host_sim/live/screen/text.hpp"
#include "host_sim/live/state/bus_picture.hpp"

namespace live {

std::vector<Span> bus_fields(const BusPicture& picture, bool ended);
std::vector<Span> node_fields(const BusPicture& picture, int number);
Span diagnosis_field(const NodeState& node);
Span event_field(const Event& event, uint64_t start_ns);
std::string duration_text(uint64_t duration_ns);         // "12.3 s"
uint64_t time_since(uint64_t then_ns, uint64_t now_ns);  // never negative

}  // namespace live
