// Roots of block-floating numbers, and their way to whole ones.
#include "firmware/fixed_point/magnitude.hpp"
#include "firmware/fixed_point/scaled.hpp"
#include "firmware/fixed_point/wide.hpp"
#include "firmware/fixed_point/work_meter.hpp"

namespace firmware {
namespace {

constexpr int kMantissaBits = 62;
constexpr int64_t kLargestMantissa = (int64_t{1} << kMantissaBits) - 1;
// What they take on a small processor, for what is done in slices.
constexpr int32_t kRootWork = 1000, kInverseRootWork = 150;

}  // namespace

Scaled sqrt(const Scaled& a) {
  report_work(kRootWork);
  if (a.mantissa <= 0) return {};
  // Even exponent: mantissa * 2^(60 - drop) = radicand * 2^56 has 119 or 120 bits, its root 60.
  const int drop = (a.exponent & 1) ? 3 : 2;
  const uint64_t root = nearest_root(static_cast<uint64_t>(a.mantissa) << (4 - drop));
  return Scaled::from_int(static_cast<int64_t>(root), (a.exponent + drop - 60) / 2);
}

Scaled root_of_squares(const Scaled& a, const Scaled& b) { return sqrt(a * a + b * b); }

Scaled inverse_root(const Scaled& a) {
  report_work(kInverseRootWork);
  if (a.mantissa <= 0) return {};
  // a = z 2^(exponent - n), z = mantissa 2^n / 2^32 of 31 or 32 bits, the exponent even.
  const int up = (a.exponent & 1) ? 1 : 2;
  const uint32_t z = static_cast<uint32_t>((static_cast<uint64_t>(a.mantissa) << up) >> 32);
  return Scaled::from_int(reciprocal_root(z), -30 - (a.exponent - up + 64) / 2);
}

int64_t to_fixed(const Scaled& a, int32_t fraction_bits) {
  if (a.mantissa == 0) return 0;
  const int64_t shift = static_cast<int64_t>(a.exponent) + fraction_bits;
  if (shift >= 1) return a.mantissa < 0 ? -kLargestMantissa : kLargestMantissa;
  if (shift == 0) return a.mantissa;
  if (shift < -kMantissaBits) return 0;
  const uint64_t value = magnitude(a.mantissa);
  const int drop = static_cast<int>(-shift);
  const auto rounded = static_cast<int64_t>((value >> drop) + ((value >> (drop - 1)) & 1u));
  return a.mantissa < 0 ? -rounded : rounded;
}

int32_t log2_floor(const Scaled& a) { return a.mantissa == 0 ? INT32_MIN : a.exponent + kMantissaBits - 1; }

}  // namespace firmware
