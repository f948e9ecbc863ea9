#include "firmware/energy/batch_table.hpp"

namespace firmware {
namespace {
constexpr int kPackedMantissaBits = 48;  // sign included
constexpr int kDroppedBits = 15;         // 62-bit magnitude to 47
}  // namespace

PackedScaled pack(Scaled value) {
  if (value.is_zero()) return {};
  int64_t mantissa = (value.mantissa + (int64_t{1} << (kDroppedBits - 1))) >> kDroppedBits;
  int32_t exponent = value.exponent + kDroppedBits;
  const int64_t limit = int64_t{1} << (kPackedMantissaBits - 1);
  if (mantissa >= limit || mantissa < -limit) {  // rounding carried into a new bit
    mantissa >>= 1;
    ++exponent;
  }
  if (exponent > INT16_MAX) return {};
  if (exponent < INT16_MIN) return {};
  return {static_cast<int64_t>((static_cast<uint64_t>(mantissa) << 16) | static_cast<uint16_t>(exponent))};
}

Scaled unpack(PackedScaled packed) {
  return Scaled::from_int(packed.bits >> 16, static_cast<int16_t>(packed.bits & 0xffff));
}

}  // namespace firmware
