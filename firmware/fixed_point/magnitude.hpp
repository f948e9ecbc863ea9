// |value| without overflow, also of the most negative number.
#pragma once
#include <cstdint>

namespace firmware {

constexpr uint64_t magnitude(int64_t value) {
  return value < 0 ? ~static_cast<uint64_t>(value) + 1 : static_cast<uint64_t>(value);
}

}  // namespace firmware
