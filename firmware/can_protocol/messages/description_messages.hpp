// What the numbers of the node mean, told now and then on the bus: names of the estimates, units and ranges of the channels.
#pragma once
#include <cstdint>

#include "firmware/can_protocol/values/place.hpp"
#include "firmware/configuration/configuration.hpp"
#include "firmware/vocabulary/effect_table.hpp"

namespace firmware {

// Name of an estimate: index among the unknowns, kind and place of its term.
struct ParameterDescription {
  uint8_t index = 0;
  uint8_t count = 0;
  TermKind kind = TermKind::kMass;
  uint8_t place_a = 0, place_b = kNoPlace;
  bool rotating = false;
};
// Of the first term that carries the unknown; false where there is none.
bool describe_parameter(const CoreConfiguration& configuration, int unknown, bool rotating,
                        ParameterDescription& result);

// What turns the codes of a channel into SI units.
struct ChannelScaling {
  uint8_t place = 1;
  Quantity quantity = Quantity::kForce;
  bool rotating = false;
  int8_t exponent = 0;
  int32_t unit_per_code = 0;  // times 10^exponent
  int32_t delay_us = 0;       // whole microseconds
};
struct ChannelRange {
  uint8_t place = 1;
  Quantity quantity = Quantity::kForce;
  bool rotating = false;
  int32_t offset_code = 0;
  int32_t full_scale_code = 8388607;
};
ChannelScaling channel_scaling(const ChannelConfiguration& channel, int node, Quantity quantity, bool rotating);
ChannelRange channel_range(const ChannelConfiguration& channel, int node, Quantity quantity, bool rotating);

}  // namespace firmware
