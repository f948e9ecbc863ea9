#include "firmware/can_protocol/messages.hpp"

#include "firmware/can_protocol/decimal.hpp"
#include "firmware/can_protocol/estimate_frames.hpp"

namespace firmware {
namespace {

constexpr int64_t kLargestInt32 = 2147483647;
constexpr uint8_t kNoPlace = 31;

}  // namespace

NodeStatus node_status(const Estimates& estimates, ControllerMode mode, uint16_t faults) {
  NodeStatus status;
  status.faults = faults;
  status.mode = mode;
  status.update_counter = estimates.window_counter;
  if (!estimates.condition_number.is_zero()) {
    const int32_t log2 = log2_floor(estimates.condition_number);
    status.condition_log2 = static_cast<uint8_t>(log2 < 0 ? 0 : log2 > 255 ? 255 : log2);
  }
  if (estimates.unknown_count > 0) status.quality = EstimateStatus::kValid;
  for (int i = 0; i < estimates.unknown_count; ++i)
    if (severity(estimates.parameters[i].status) > severity(status.quality))
      status.quality = estimates.parameters[i].status;
  return status;
}

WindowResult window_result(const Estimates& estimates) {
  WindowResult result;
  result.residual_e9 = static_cast<uint32_t>(decimal_mantissa(abs(estimates.residual_mean_abs), -9, 0xFFFFFFFFll));
  result.equations = estimates.rows;
  result.window = estimates.window_counter;
  return result;
}

namespace {

uint8_t place_of(int8_t node) { return node < 0 ? kNoPlace : place_of_node(node); }
uint16_t permille(Scaled part) {
  const int64_t value = to_fixed(abs(part) * Scaled::from_int(1000), 0);
  return static_cast<uint16_t>(value > 65535 ? 65535 : value);
}

}  // namespace

Diagnosis diagnosis_of(const Estimates& estimates) {
  const Warrant& warrant = estimates.warrant;
  Diagnosis diagnosis;
  diagnosis.cause = warrant.named.cause;
  diagnosis.place_a = place_of(warrant.named.node_a);
  diagnosis.place_b = place_of(warrant.named.node_b);
  diagnosis.quantity = warrant.named.quantity;
  diagnosis.unexplained_permille = permille(warrant.force_ratio);
  diagnosis.gained_permille = permille(warrant.gained);
  ParameterEstimate size;
  size.value = warrant.named.size;
  size.std = warrant.named.std;
  const EstimateRecord record = estimate_record(size, 0);
  diagnosis.size = {record.value, record.std, record.exponent, record.std_exponent};
  diagnosis.rival = warrant.rival.cause;
  diagnosis.rival_place_a = place_of(warrant.rival.node_a);
  diagnosis.rival_place_b = place_of(warrant.rival.node_b);
  diagnosis.rival_quantity = warrant.rival.quantity;
  diagnosis.rival_permille = permille(warrant.rival_share);
  return diagnosis;
}

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
