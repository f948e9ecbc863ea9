// What may be wrong with the rig's model or a channel, numbered as on the bus: a row of the vocabulary, or one of these.
#pragma once
#include <cstdint>

#include "firmware/vocabulary/effect_table.hpp"

namespace firmware {

enum class Cause : uint8_t {
  kNone = 0,
  kPolarity = 252,  // a channel is turned over
  kUnit = 253,      // a channel is in another unit: 9.81 or 1000 times what it should say, or as little
  kAmbiguous = 254,
  kUnknown = 255,
};
constexpr Cause cause_of(EffectKind kind) { return static_cast<Cause>(row_of(kind).can.number); }

constexpr uint8_t kNoQuantity = 7;  // where the cause is not in a channel

}  // namespace firmware
