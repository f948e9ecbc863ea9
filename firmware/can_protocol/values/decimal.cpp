#include "firmware/can_protocol/values/decimal.hpp"

#include "firmware/fixed_point/precondition.hpp"

namespace firmware {
namespace {

constexpr int32_t kExactPower = 26;

Scaled power_of_ten(int32_t exponent) {  // exponent >= 0
  Scaled result = Scaled::from_int(1);
  while (exponent > 0) {
    const int32_t part = exponent < kExactPower ? exponent : kExactPower;
    int64_t power_of_five = 1;
    for (int32_t i = 0; i < part; ++i) power_of_five *= 5;
    result = result * Scaled::from_int(power_of_five, part);
    exponent -= part;
  }
  return result;
}

Scaled times_power_of_ten(Scaled value, int32_t exponent) {
  if (exponent == 0 || value.is_zero()) return value;
  return exponent > 0 ? value * power_of_ten(exponent) : value / power_of_ten(-exponent);
}

}  // namespace

int64_t decimal_mantissa(Scaled value, int32_t exponent, int64_t limit) {
  FIRMWARE_PRECONDITION(limit > 0 && limit <= int64_t{1} << 61);
  if (value.is_zero()) return 0;
  int64_t digits = to_fixed(times_power_of_ten(abs(value), -exponent), 0);
  if (digits > limit) digits = limit;
  return value.is_negative() ? -digits : digits;
}

Decimal to_decimal(Scaled value, int64_t limit, int32_t lowest, int32_t highest) {
  FIRMWARE_PRECONDITION(lowest >= -kExactPower && lowest <= highest && highest <= kExactPower);
  if (value.is_zero()) return Decimal{0, lowest};
  // A first guess from the binary exponents (log10 2 is close to 1233 / 4096), then a step or two.
  const int64_t decades = (static_cast<int64_t>(log2_floor(value)) - log2_floor(Scaled::from_int(limit))) * 1233 / 4096;
  int32_t exponent = static_cast<int32_t>(decades < lowest ? lowest : decades > highest ? highest : decades);
  const int64_t too_much = limit + 1;
  const auto fits = [&](int32_t e) {
    const int64_t mantissa = decimal_mantissa(value, e, too_much);
    return mantissa > -too_much && mantissa < too_much;
  };
  while (exponent > lowest && fits(exponent - 1)) --exponent;
  while (exponent < highest && !fits(exponent)) ++exponent;
  return Decimal{decimal_mantissa(value, exponent, limit), exponent};
}

Scaled from_decimal(Decimal decimal) {
  return times_power_of_ten(Scaled::from_int(decimal.mantissa), decimal.exponent);
}

}  // namespace firmware
