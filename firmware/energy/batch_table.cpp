#include "firmware/energy/batch_table.hpp"

#include "firmware/fixed_point/magnitude.hpp"
#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {
namespace {
constexpr int kPackedMantissaBits = 48;  // sign included
constexpr int kDroppedBits = 15;         // 62-bit magnitude to 47
constexpr int kScaledBits = 62;
constexpr int64_t kLowest = -(int64_t{1} << (kPackedMantissaBits - 1));  // not normal: its magnitude has 48 bits
}  // namespace

[[gnu::noinline]] static PackedScaled packed(int32_t exponent, int64_t mantissa) {  // of a Scaled that is not 0
  mantissa = (mantissa + (int64_t{1} << (kDroppedBits - 1))) >> kDroppedBits;
  exponent += kDroppedBits;
  const int64_t limit = int64_t{1} << (kPackedMantissaBits - 1);
  if (mantissa >= limit || mantissa < -limit) {  // rounding carried into a new bit
    mantissa >>= 1;
    ++exponent;
  }
  if (exponent > INT16_MAX) return {};
  if (exponent < INT16_MIN) return {};
  return {static_cast<int64_t>((static_cast<uint64_t>(mantissa) << 16) | static_cast<uint16_t>(exponent))};
}

PackedScaled pack(const Scaled& value) {
  return value.is_zero() ? PackedScaled{} : packed(value.exponent, value.mantissa);
}

[[gnu::noinline]] static Scaled unreported_number(PackedScaled packed) {
  const int64_t mantissa = packed.bits >> 16;
  const int32_t exponent = static_cast<int16_t>(packed.bits & 0xffff);
  if (mantissa == 0) return {};
  if (mantissa == kLowest) return Scaled::from_int(mantissa, exponent);
  return {mantissa * (int64_t{1} << kDroppedBits), exponent - kDroppedBits};
}

[[gnu::noinline, gnu::cold]] static Scaled reported_number(PackedScaled packed) {
  report_work(130);  // with the sum that it goes into
  return unreported_number(packed);
}
Scaled unpack(PackedScaled packed) {
  return work_meter == nullptr ? unreported_number(packed) : reported_number(packed);
}

#if UINTPTR_MAX <= UINT32_MAX && FIRMWARE_FILTER_HALF == 0
// A small core takes the plain way: it has time for it, as it has no filters that work with every sample.
constexpr int32_t kSumWork = 320;
[[gnu::noinline]] static PackedScaled unreported_sum(PackedScaled a, PackedScaled b) {
  Scaled sum = unreported_number(a);
  sum += unreported_number(b);
  return pack(sum);
}
#else
constexpr int32_t kSumWork = 160;
// Both mantissas are normal, 47 bits; Scaled's are these times 2^15.
[[gnu::noinline]] static PackedScaled unreported_sum(PackedScaled a, PackedScaled b) {
  int64_t left = a.bits >> 16, right = b.bits >> 16;
  if (left == kLowest || right == kLowest) return pack(unreported_number(a) + unreported_number(b));
  if (left == 0) return b;
  if (right == 0) return a;
  int32_t exponent = static_cast<int16_t>(a.bits & 0xffff), other = static_cast<int16_t>(b.bits & 0xffff);
  if (exponent < other) {
    const int64_t swap = left;
    left = right;
    right = swap;
    const int32_t swap_exponent = exponent;
    exponent = other;
    other = swap_exponent;
  }
  const int32_t distance = exponent - other;
  if (distance > kScaledBits)
    return {static_cast<int64_t>((static_cast<uint64_t>(left) << 16) | static_cast<uint16_t>(exponent))};
  const int64_t one = left * (int64_t{1} << kDroppedBits), two = right * (int64_t{1} << kDroppedBits);
  const int64_t sum = one + (distance == 0 ? two : ((two >> (distance - 1)) + 1) >> 1);
  if (is_surely_normal(sum)) {
    const int64_t mantissa = (sum + (int64_t{1} << (kDroppedBits - 1))) >> kDroppedBits;
    if (mantissa < -kLowest && mantissa >= kLowest)
      return {static_cast<int64_t>((static_cast<uint64_t>(mantissa) << 16) | static_cast<uint16_t>(exponent))};
  }
  if (sum == 0) return {};
  uint64_t value = magnitude(sum);
  const int shift = __builtin_clzll(value) - (64 - kScaledBits);
  if (shift >= 0) {
    value <<= shift;
    exponent -= shift;
  } else {
    value = (value >> 1) + (value & 1u);
    ++exponent;
    if (value >> kScaledBits) {
      value >>= 1;
      ++exponent;
    }
  }
  const auto normal = static_cast<int64_t>(value);
  return packed(exponent - kDroppedBits, sum < 0 ? -normal : normal);
}
#endif

[[gnu::noinline, gnu::cold]] static PackedScaled reported_sum(PackedScaled a, PackedScaled b) {
  report_work(kSumWork);
  return unreported_sum(a, b);
}
PackedScaled operator+(PackedScaled a, PackedScaled b) {
  return work_meter == nullptr ? unreported_sum(a, b) : reported_sum(a, b);
}

}  // namespace firmware
