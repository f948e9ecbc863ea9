#include "host_sim/records/csv/text/decimal_number.hpp"

#include <array>
#include <cstdint>
#include <cstring>

namespace host_sim {
namespace {

constexpr int kMostDigits = 19;       // 10^19 < 2^64
constexpr int kMostPlaces = 27;       // 5^27 < 2^63
constexpr int kMostExactPlaces = 22;  // 10^22 is a double
constexpr int64_t kMostExact = int64_t{1} << 53;

constexpr auto kPowersOf5 = [] {
  std::array<uint64_t, kMostPlaces + 1> powers{1};
  for (int i = 1; i <= kMostPlaces; ++i) powers[static_cast<size_t>(i)] = 5 * powers[static_cast<size_t>(i) - 1];
  return powers;
}();
constexpr auto kPowersOf10 = [] {
  std::array<double, kMostExactPlaces + 1> powers{1.0};
  for (int i = 1; i <= kMostExactPlaces; ++i)
    powers[static_cast<size_t>(i)] = 10.0 * powers[static_cast<size_t>(i) - 1];
  return powers;
}();

// Digits of a number as they stand: digits * 10^-places.
struct Decimal {
  uint64_t digits = 0;
  int places = 0;
};

bool digit(char c) { return static_cast<unsigned char>(c - '0') < 10; }

#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
constexpr uint64_t kTenTo[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

// How many of eight characters, the first of them lowest, are digits before one that is none. A carry of the sum comes from a
// character that is none and only reaches those behind it.
int leading_digits(uint64_t text) {
  constexpr uint64_t kHigh = 0xF0F0F0F0F0F0F0F0u, kThrees = 0x3030303030303030u, kSixes = 0x0606060606060606u;
  const uint64_t other = ((text ^ kThrees) | ((text + kSixes) ^ kThrees)) & kHigh;
  return other == 0 ? 8 : __builtin_ctzll(other) / 8;
}
// Pairs, then pairs of pairs, then both halves, side by side in one word.
uint64_t number_of_eight(uint64_t text) {
  text = (text & 0x0F0F0F0F0F0F0F0Fu) * (10 * 256 + 1) >> 8;
  text = (text & 0x00FF00FF00FF00FFu) * (100 * 65536 + 1) >> 16;
  return (text & 0x0000FFFF0000FFFFu) * (10000 * (uint64_t{1} << 32) + 1) >> 32;
}
#endif

// Takes digits off the front into `digits`, which overflows where they are too many.
inline void take_digits(const char*& at, const char* last, uint64_t& digits) {
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  for (uint64_t text; last - at >= 8;) {
    std::memcpy(&text, at, sizeof text);
    const int count = leading_digits(text);
    if (count < 8) {
      if (count > 0) digits = kTenTo[count] * digits + number_of_eight(text << (64 - 8 * count));  // zeros in front
      at += count;
      return;
    }
    digits = kTenTo[8] * digits + number_of_eight(text);
    at += 8;
  }
#endif
  for (; at != last && digit(*at); ++at) digits = 10 * digits + static_cast<uint64_t>(*at - '0');
}

// 2^exponent, of a normal number.
double power_of_2(int exponent) {
  const uint64_t bits = static_cast<uint64_t>(exponent + 1023) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

#if defined(__SIZEOF_INT128__)
// floor(upper 2^63 / below), upper and below from 2^63 on, and whether anything is left.
inline uint64_t divided(uint64_t upper, uint64_t below, bool& rest) {
#if defined(__x86_64__)
  uint64_t whole, left;  // the upper half, upper / 2, is below the divisor
  __asm__("divq %4" : "=a"(whole), "=d"(left) : "a"(upper << 63), "d"(upper >> 1), "r"(below) : "cc");
  rest = left != 0;
  return whole;
#else
  __extension__ using Wide = unsigned __int128;
  const Wide numerator = static_cast<Wide>(upper) << 63;
  const uint64_t whole = static_cast<uint64_t>(numerator / below);
  rest = static_cast<Wide>(whole) * below != numerator;
  return whole;
#endif
}

// The nearest double, ties to even: the quotient by 5^places to 63 bits or 64, whose last bit says whether anything is left. The
// conversion of 64 bits to 53 rounds once, and powers of two change no digit.
double quotient(const Decimal& decimal) {
  const uint64_t divisor = kPowersOf5[static_cast<size_t>(decimal.places)];
  const int up = __builtin_clzll(decimal.digits), up_divisor = __builtin_clzll(divisor);
  bool rest = false;
  uint64_t whole = divided(decimal.digits << up, divisor << up_divisor, rest);
  const uint64_t half = whole >> 1 | (whole & 1) | (rest ? 1 : 0);  // a number with sign: no processor asks which it is
  return static_cast<double>(static_cast<int64_t>(half)) * power_of_2(up_divisor - up - 62 - decimal.places);
}
constexpr bool kDivides = true;
#else
double quotient(const Decimal&) { return 0.0; }
constexpr bool kDivides = false;
#endif

}  // namespace

std::from_chars_result read_decimal(const char* first, const char* last, double& value) {
  const char* at = first;
  const bool negative = at != last && *at == '-';
  if (negative) ++at;
  Decimal decimal;
  const char* const start = at;
  for (; at != last && digit(*at); ++at) decimal.digits = 10 * decimal.digits + static_cast<uint64_t>(*at - '0');
  auto count = at - start;
  if (at != last && *at == '.') {
    const char* const point = at++;
    take_digits(at, last, decimal.digits);
    decimal.places = static_cast<int>(at - point - 1);
    count += decimal.places;
  }
  const bool any = count > 0, plain = at == last || (*at | 0x20) != 'e';
  // Zeros in front are no digits: 0.00 and the like stand before the others.
  if (any && *start == '0') --count;
  if (count > kMostDigits)
    for (const char* zero = *start == '0' ? start + 1 : start; zero != at && (*zero == '0' || *zero == '.'); ++zero)
      count -= *zero == '0' ? 1 : 0;
  const bool exact = decimal.digits <= kMostExact && decimal.places <= kMostExactPlaces;
  const bool divides = kDivides && decimal.digits != 0 && decimal.places <= kMostPlaces;
  if (!any || !plain || count > kMostDigits || !(exact || divides))
    return std::from_chars(first, last, value);  // words, powers of ten, more digits
  const double size = exact ? static_cast<double>(decimal.digits) / kPowersOf10[static_cast<size_t>(decimal.places)]
                            : quotient(decimal);
  value = negative ? -size : size;
  return {at, std::errc()};
}

}  // namespace host_sim
