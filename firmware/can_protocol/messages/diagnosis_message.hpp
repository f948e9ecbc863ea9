// What the node says of its own model: the cause that the warrant named (firmware/warrant), as it travels on the bus.
#pragma once
#include <cstdint>

#include "firmware/can_protocol/values/place.hpp"
#include "firmware/identification/estimate.hpp"
#include "firmware/vocabulary/cause.hpp"

namespace firmware {

// A number with its deviation, in decimal: value * 10^exponent, std * 10^(exponent + std_exponent), SI units.
struct DecimalSize {
  int32_t value = 0;
  uint16_t std = 0;
  int8_t exponent = 0;
  uint8_t std_exponent = 0;
};

struct Diagnosis {
  Cause cause = Cause::kNone;
  uint8_t place_a = kNoPlace, place_b = kNoPlace;
  uint8_t quantity = kNoQuantity;
  uint16_t unexplained_permille = 0;
  uint16_t gained_permille = 0;
  DecimalSize size;
  bool corrected = false;
  Cause rival = Cause::kNone;
  uint8_t rival_place_a = kNoPlace, rival_place_b = kNoPlace;
  uint8_t rival_quantity = kNoQuantity;
  uint16_t rival_permille = 0;
};

// As the last solve's warrant has it.
Diagnosis diagnosis_of(const Estimates& estimates);

}  // namespace firmware
