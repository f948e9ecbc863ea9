// One simultaneous sample of all channels, as the converters gave it.
#pragma once
#include <cstdint>

#include "firmware/configuration/configuration.hpp"

namespace firmware {

struct RawSample {
  uint32_t sequence = 0;                      // counts samples; a jump is a missed sample
  uint64_t time_ns = 0;                       // of the sample clock
  int32_t code[kMaxNodes][kQuantities] = {};  // ADC codes, up to 24 bits with sign; absent channels are 0
};

}  // namespace firmware
