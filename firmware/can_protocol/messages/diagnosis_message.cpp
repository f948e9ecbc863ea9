#include "firmware/can_protocol/messages/diagnosis_message.hpp"

#include "firmware/can_protocol/streams/estimate_frames.hpp"

namespace firmware {
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
  diagnosis.corrected = warrant.corrected;
  // Where nothing explains it the nearest cause stands where the rival would.
  const bool explains = warrant.naming == Naming::kExplains;
  const Finding& rival = explains ? warrant.rival : warrant.named;
  if (!explains && diagnosis.cause != Cause::kNone) diagnosis.cause = Cause::kUnknown;
  diagnosis.rival = rival.cause;
  diagnosis.rival_place_a = place_of(rival.node_a);
  diagnosis.rival_place_b = place_of(rival.node_b);
  diagnosis.rival_quantity = rival.quantity;
  diagnosis.rival_permille = explains ? permille(warrant.rival_share) : 1000;
  return diagnosis;
}

}  // namespace firmware
