#include "firmware/can_protocol/messages/description_messages.hpp"

#include "firmware/can_protocol/values/decimal.hpp"

namespace firmware {
namespace {

constexpr int64_t kLargestInt32 = 2147483647;

}  // namespace

bool describe_parameter(const CoreConfiguration& configuration, int unknown, bool rotating,
                        ParameterDescription& result) {
  for (int i = 0; i < configuration.term_count; ++i) {
    const Term& term = configuration.terms[i];
    if (term.unknown != unknown) continue;
    result.index = static_cast<uint8_t>(unknown);
    result.count = configuration.unknown_count;
    result.kind = term.kind;
    result.rotating = rotating;
    if (term.kind == TermKind::kMass) {
      result.place_a = place_of_node(term.place);
      result.place_b = kNoPlace;
    } else {
      result.place_a = place_of_node(configuration.links[term.place].node_a);
      result.place_b = place_of_node(configuration.links[term.place].node_b);
    }
    return true;
  }
  return false;
}

ChannelScaling channel_scaling(const ChannelConfiguration& channel, int node, Quantity quantity, bool rotating) {
  const Decimal unit = to_decimal(channel.unit_per_code, kLargestInt32, -26, 26);
  ChannelScaling scaling;
  scaling.place = place_of_node(node);
  scaling.quantity = quantity;
  scaling.rotating = rotating;
  scaling.exponent = static_cast<int8_t>(unit.exponent);
  scaling.unit_per_code = static_cast<int32_t>(unit.mantissa);
  scaling.delay_us = channel.delay_ns / 1000;
  return scaling;
}

ChannelRange channel_range(const ChannelConfiguration& channel, int node, Quantity quantity, bool rotating) {
  ChannelRange range;
  range.place = place_of_node(node);
  range.quantity = quantity;
  range.rotating = rotating;
  range.offset_code = channel.offset_code;
  range.full_scale_code = channel.highest_code > -channel.lowest_code ? channel.highest_code : -channel.lowest_code;
  return range;
}

}  // namespace firmware
