#include "host_sim/can_log/known_causes.hpp"

#include "firmware/can_protocol/value_tables.hpp"
#include "firmware/vocabulary/effect_table.hpp"
#include "host_sim/can_log/readable.hpp"

namespace can_log {
namespace {

using firmware::Cause;

bool is_named(Cause cause) { return cause != Cause::kNone && cause != Cause::kAmbiguous && cause != Cause::kUnknown; }

const firmware::EffectRow* row_of_cause(Cause cause) {
  for (const firmware::EffectRow& row : firmware::kEffectTable)
    if (row.can.number != 0 && row.can.number == static_cast<uint8_t>(cause)) return &row;
  return nullptr;
}

}  // namespace

CauseSize size_of(const firmware::DecimalSize& size) {
  return {times_power_of_ten(size.value, size.exponent),
          times_power_of_ten(size.std, size.exponent + size.std_exponent)};
}

void KnownCauses::learn(const firmware::CanFrame& message) {
  int node = 0;
  firmware::Diagnosis said;
  if (firmware::unpack_diagnosis(message, node, said)) last_[node] = said;
}

std::string KnownCauses::label(int node) const {
  const firmware::Diagnosis& said = last_[node];
  const std::string effect =
      state_name(firmware::can::states(firmware::can::kCauses), static_cast<int64_t>(said.cause));
  if (!is_named(said.cause) || effect.empty() || said.place_a == firmware::can::kPlaceNone) return "size";
  if (said.quantity != firmware::kNoQuantity) return effect + "[" + channel_label(said.place_a, said.quantity) + "]";
  const bool of_link = said.place_b != firmware::can::kPlaceNone;
  return effect + "[" + place_label(said.place_a) + (of_link ? "-" + place_label(said.place_b) : "") + "]";
}

std::string KnownCauses::unit(int node, const KnownNames& names) const {
  const firmware::Diagnosis& said = last_[node];
  if (!is_named(said.cause)) return "SI";
  const firmware::EffectRow* row = row_of_cause(said.cause);
  if (row == nullptr) return "1";  // a sign or a unit: a factor
  const char* unit = row->unit.of(row->unit.translating == nullptr || names.rotates(node, said.place_a));
  return unit == nullptr ? "SI" : unit;
}

}  // namespace can_log
