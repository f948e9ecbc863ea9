// The frames that name estimates and channels.
#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/messages/raw_values.hpp"

namespace firmware {

CanFrame pack_parameter(int node, const ParameterDescription& parameter) {
  return can::pack<can::kParameter>(node, 0,
                                    {parameter.index, parameter.count, static_cast<int64_t>(parameter.kind),
                                     parameter.place_a, parameter.place_b, parameter.rotating});
}

bool unpack_parameter(const CanFrame& message, int& node, ParameterDescription& parameter) {
  int64_t raw[6];
  if (!unpack(can::kParameter, message, node, raw)) return false;
  assign(parameter.index, raw[0]);
  assign(parameter.count, raw[1]);
  assign(parameter.kind, raw[2]);
  assign(parameter.place_a, raw[3]);
  assign(parameter.place_b, raw[4]);
  parameter.rotating = raw[5] != 0;
  return true;
}

CanFrame pack_scaling(int node, const ChannelScaling& scaling) {
  return can::pack<can::kScaling>(node, 0,
                                  {scaling.place, static_cast<int64_t>(scaling.quantity), scaling.rotating,
                                   scaling.exponent, scaling.unit_per_code, scaling.delay_us});
}

bool unpack_scaling(const CanFrame& message, int& node, ChannelScaling& scaling) {
  int64_t raw[6];
  if (!unpack(can::kScaling, message, node, raw)) return false;
  assign(scaling.place, raw[0]);
  assign(scaling.quantity, raw[1]);
  scaling.rotating = raw[2] != 0;
  assign(scaling.exponent, raw[3]);
  assign(scaling.unit_per_code, raw[4]);
  assign(scaling.delay_us, raw[5]);
  return true;
}

CanFrame pack_range(int node, const ChannelRange& range) {
  return can::pack<can::kRange>(
      node, 0,
      {range.place, static_cast<int64_t>(range.quantity), range.rotating, range.offset_code, range.full_scale_code});
}

bool unpack_range(const CanFrame& message, int& node, ChannelRange& range) {
  int64_t raw[5];
  if (!unpack(can::kRange, message, node, raw)) return false;
  assign(range.place, raw[0]);
  assign(range.quantity, raw[1]);
  range.rotating = raw[2] != 0;
  assign(range.offset_code, raw[3]);
  assign(range.full_scale_code, raw[4]);
  return true;
}

}  // namespace firmware
