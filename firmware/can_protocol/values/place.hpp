// A place on the bus: 0 ground, 1 to 16 a DOF, 17 the base, 31 none. Node indices of the core are 0-based.
#pragma once
#include <cstdint>

#include "firmware/configuration/configuration.hpp"

namespace firmware {

constexpr uint8_t kNoPlace = 31;
constexpr uint8_t place_of_node(int node) {
  return static_cast<uint8_t>(node == kGroundNode ? 0 : wire_node(node) + 1);
}

}  // namespace firmware
