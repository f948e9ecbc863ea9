// Fixed-point numbers of the per-sample path. The binary point is part of the type: value = raw * 2^-FractionBits.
// Adding or comparing different formats does not compile; a product carries the sum of both fraction bits.
#pragma once
#include <cstdint>
#include <type_traits>

namespace firmware {

template <typename Storage, int FractionBits>
struct Fixed {
  static_assert(std::is_integral<Storage>::value && std::is_signed<Storage>::value, "signed integer storage");
  using storage_type = Storage;
  static constexpr int kFractionBits = FractionBits;

  Storage raw = 0;

  static constexpr Fixed from_raw(Storage raw_value) {
    Fixed result;
    result.raw = raw_value;
    return result;
  }
};

template <typename S, int F>
constexpr Fixed<S, F> operator+(Fixed<S, F> a, Fixed<S, F> b) {
  return Fixed<S, F>::from_raw(static_cast<S>(a.raw + b.raw));
}
template <typename S, int F>
constexpr Fixed<S, F> operator-(Fixed<S, F> a, Fixed<S, F> b) {
  return Fixed<S, F>::from_raw(static_cast<S>(a.raw - b.raw));
}
template <typename S, int F>
constexpr bool operator<(Fixed<S, F> a, Fixed<S, F> b) {
  return a.raw < b.raw;
}
template <typename S, int F>
constexpr bool operator==(Fixed<S, F> a, Fixed<S, F> b) {
  return a.raw == b.raw;
}
template <typename S, int F>
constexpr Fixed<S, F> operator-(Fixed<S, F> a) {
  return Fixed<S, F>::from_raw(static_cast<S>(-a.raw));
}
// A whole number of times.
template <typename S, int F>
constexpr Fixed<S, F> operator*(int32_t times, Fixed<S, F> a) {
  return Fixed<S, F>::from_raw(static_cast<S>(times * a.raw));
}
// a / 2^bits, rounded down.
template <typename S, int F>
constexpr Fixed<S, F> operator>>(Fixed<S, F> a, int bits) {
  return Fixed<S, F>::from_raw(static_cast<S>(a.raw >> bits));
}
template <typename S, int F>
constexpr int32_t sign_of(Fixed<S, F> a) {
  return static_cast<int32_t>(a.raw > 0) - static_cast<int32_t>(a.raw < 0);
}
// |a|, for what is not the most negative number.
template <typename S, int F>
constexpr Fixed<S, F> size_of(Fixed<S, F> a) {
  return a.raw < 0 ? -a : a;
}
template <typename S, int F>
constexpr Fixed<S, F> limited(Fixed<S, F> a, Fixed<S, F> limit) {
  return limit < a ? limit : a < -limit ? -limit : a;
}
// The exact product: always 64 bits wide, so two 32-bit factors cannot overflow.
template <typename SA, int FA, typename SB, int FB>
constexpr Fixed<int64_t, FA + FB> operator*(Fixed<SA, FA> a, Fixed<SB, FB> b) {
  static_assert(sizeof(SA) <= 4 && sizeof(SB) <= 4, "factors of a product have 32 bits or less");
  return Fixed<int64_t, FA + FB>::from_raw(static_cast<int64_t>(a.raw) * b.raw);
}
// Change of format, spelled out: rounds to nearest when bits are dropped.
template <typename To, typename S, int F>
constexpr To rescale(Fixed<S, F> a) {
  constexpr int shift = F - To::kFractionBits;
  if constexpr (shift > 0) {
    return To::from_raw(
        static_cast<typename To::storage_type>((static_cast<int64_t>(a.raw) + (int64_t{1} << (shift - 1))) >> shift));
  } else {
    return To::from_raw(static_cast<typename To::storage_type>(static_cast<int64_t>(a.raw) * (int64_t{1} << -shift)));
  }
}

}  // namespace firmware
