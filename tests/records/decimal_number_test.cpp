// Numbers of a text against std::from_chars, bit by bit.
#include "host_sim/records/csv/text/decimal_number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>

namespace {

using host_sim::read_decimal;

uint64_t bits_of(double value) {
  uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

void expect_as_from_chars(const std::string& text) {
  double value = 1.5, expected = 1.5;
  const auto ours = read_decimal(text.data(), text.data() + text.size(), value);
  const auto theirs = std::from_chars(text.data(), text.data() + text.size(), expected);
  EXPECT_EQ(ours.ec, theirs.ec) << text;
  EXPECT_EQ(ours.ptr - text.data(), theirs.ptr - text.data()) << text;
  EXPECT_EQ(bits_of(value), bits_of(expected)) << text;
}

TEST(DecimalNumber, ByHand) {
  const auto value_of = [](const std::string& text) {
    double value = NAN;
    read_decimal(text.data(), text.data() + text.size(), value);
    return value;
  };
  EXPECT_EQ(value_of("0.5"), 0.5);
  EXPECT_EQ(value_of("-12.25,7"), -12.25);
  EXPECT_EQ(value_of("0.1"), 0x1.999999999999ap-4);  // 1.1001 1001 .. and the next digits 1001: up
  // Half way between 2^53 and the next double 2^53 + 2: to the even one; a little more: up.
  EXPECT_EQ(value_of("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(value_of("9007199254740993.001"), 9007199254740994.0);
  EXPECT_EQ(value_of("9007199254740995"), 9007199254740996.0);
}

TEST(DecimalNumber, WhateverStandsThere) {
  for (const char* text : {"",
                           "-",
                           ".",
                           "-.",
                           "0",
                           "-0",
                           "0.",
                           ".5",
                           "-.5",
                           "5.",
                           "00012",
                           "1e5",
                           "1E-7",
                           "1e",
                           "1.5e+300",
                           "1e400",
                           "nan",
                           "inf",
                           "-inf",
                           "abc",
                           "1x",
                           "0x10",
                           "1..2",
                           "1.2.3",
                           "--1",
                           "+1",
                           "1,5",
                           "1 2",
                           "1\"",
                           "0.0",
                           "0.000000000000000000000000000",
                           "0.000000000000000000000000001",
                           "18446744073709551615",
                           "18446744073709551616",
                           "9999999999999999999",
                           "99999999999999999999",
                           "1234567890123456789012345",
                           "0.1234567890123456789012345",
                           "0.000000001234567890123456789",
                           "9007199254740993.0000000000"})
    expect_as_from_chars(text);
}

TEST(DecimalNumber, AnyDigitsAndPlaces) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 300000; ++i) {
    const size_t digits = 1 + random() % 21, places = random() % 30;
    std::string text;
    for (size_t k = 0; k < digits; ++k) text += static_cast<char>('0' + random() % 10);
    if (places >= digits) text.insert(0, places - digits + 1, '0');
    text.insert(text.size() - places, ".");
    expect_as_from_chars((i % 2 == 0 ? "-" : "") + text);
  }
}

// The shortest text of a double and that of the half between two: what rounds the wrong way shows there.
TEST(DecimalNumber, DoublesAndHalvesBetweenThem) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> exponent(-8, 15);
  char text[64];
  for (int i = 0; i < 100000; ++i) {
    const double value = std::pow(10.0, exponent(random));
    const auto shortest = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
    expect_as_from_chars(std::string(text, shortest.ptr));
    const uint64_t whole = (uint64_t{1} << 53) | random() >> 11 << 1 | 1;  // 54 bits, the last one set
    expect_as_from_chars(std::to_string(whole));
    expect_as_from_chars(std::to_string(whole / 10) + "." + std::to_string(whole % 10));
  }
}

}  // namespace
