// Sums of filters, worked out by hand.
#include "firmware/conditioning/filter_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace firmware;

namespace {

std::vector<Tap> taps(std::initializer_list<int> values) {
  std::vector<Tap> result;
  for (int value : values) result.push_back(Tap::from_raw(value));
  return result;
}
std::vector<Code> codes(std::initializer_list<int> values) {
  std::vector<Code> result;
  for (int value : values) result.push_back(Code::from_raw(value));
  return result;
}

SignalConfiguration signal_of(const std::vector<Tap>& taps, int shift) {
  SignalConfiguration signal;
  signal.half_length = static_cast<uint8_t>(taps.size() / 2);
  signal.shift = static_cast<uint8_t>(shift);
  std::copy(taps.begin(), taps.end(), signal.tap);
  return signal;
}

// 5 (1 + 9) + 2 (4 + 7) + 3 * 6 = 50 + 22 + 18 = 90; odd: 5 (9 - 1) + 2 (7 - 4) = 46.
TEST(FilterSum, EvenAndOddByHand) {
  const auto x = codes({1, 4, 6, 7, 9});
  const auto even = taps({5, 2, 3, 2, 5}), odd = taps({-5, -2, 0, 2, 5});
  EXPECT_EQ(parity_of(even.data(), 2), 1);
  EXPECT_EQ(parity_of(odd.data(), 2), -1);
  EXPECT_EQ(parity_of(taps({1, 2, 3, 2, 5}).data(), 2), 0);
  EXPECT_EQ(filter_sum(even.data(), &x[2], 2), 90);
  EXPECT_EQ(filter_sum(odd.data(), &x[2], 2), 46);
  EXPECT_EQ(even_signal(signal_of(even, 0), &x[2]).raw, 90);
  EXPECT_EQ(odd_signal(signal_of(odd, 0), &x[2]).raw, 46);
}

// Filters without a four of taps on either side, with rounds of four alone, and with a rest. Samples 100 + n about n = 0, and S the sum
// of k^2 from 1 to h: taps of 1 give 100 (2 h + 1), odd taps of k the sum of 2 k^2 = 2 S, even taps of |k| give 100 h (h + 1).
// Taps of 1 but for the oldest, which is 3, are neither: 100 (2 h + 1) + 2 (100 - h).
TEST(FilterSum, EveryLength) {
  int squares = 0;
  for (int half = 1; half <= kFilterHalf; ++half) {
    squares += half * half;
    std::vector<Code> x;
    std::vector<Tap> ones, odd, even;
    for (int k = -half; k <= half; ++k) {
      x.push_back(Code::from_raw(100 + k));
      ones.push_back(Tap::from_raw(1));
      odd.push_back(Tap::from_raw(k));
      even.push_back(Tap::from_raw(k < 0 ? -k : k));
    }
    const Code* const middle = &x[static_cast<size_t>(half)];
    EXPECT_EQ(even_signal(signal_of(ones, 0), middle).raw, 100 * (2 * half + 1)) << half;
    EXPECT_EQ(even_signal(signal_of(even, 0), middle).raw, 100 * half * (half + 1)) << half;
    EXPECT_EQ(odd_signal(signal_of(odd, 0), middle).raw, 2 * squares) << half;
    ones.front() = Tap::from_raw(3);
    EXPECT_EQ(parity_of(ones.data(), half), 0);
    EXPECT_EQ(filter_sum(ones.data(), middle, half), 100 * (2 * half + 1) + 2 * (100 - half)) << half;
  }
}

// Taps of 30 bits on the largest codes: 57 products of 2^30 2^23 = 57 2^53, which takes the upper words of the sums.
TEST(FilterSum, LargestTapsAndCodes) {
  const std::vector<Tap> taps(2 * kFilterHalf + 1, Tap::from_raw(1 << 30));
  const std::vector<Code> x(2 * kFilterHalf + 1, Code::from_raw(-(1 << 23)));
  const Code* const middle = &x[kFilterHalf];
  EXPECT_EQ(filter_sum(taps.data(), middle, kFilterHalf), -(int64_t{2 * kFilterHalf + 1} << 53));
  EXPECT_EQ(even_signal(signal_of(taps, 36), middle).raw, -((2 * kFilterHalf + 1) << 17));
}

// To nearest, halves upwards: half of 2^shift is 1, one less is 0; minus half is 0, one more is -1. Around a word's end each shift
// takes another way.
TEST(FilterSum, NearestOfEveryShift) {
  for (int shift = 1; shift < 61; ++shift) {
    const int64_t half = int64_t{1} << (shift - 1);
    EXPECT_EQ(nearest(half, shift).raw, 1) << shift;
    EXPECT_EQ(nearest(half - 1, shift).raw, 0) << shift;
    EXPECT_EQ(nearest(-half, shift).raw, 0) << shift;
    EXPECT_EQ(nearest(-half - 1, shift).raw, -1) << shift;
    EXPECT_EQ(nearest(5 * half, shift).raw, 3) << shift;  // 2.5
  }
}

// A signal is its filter's sum to nearest, whichever way it takes: 90 and 46 (above) times 2^28, by 2^shift.
TEST(FilterSum, SignalsAreSumsToNearest) {
  const auto x = codes({1, 4, 6, 7, 9});
  const int even[] = {5, 2, 3, 2, 5}, odd[] = {-5, -2, 0, 2, 5};
  SignalConfiguration signal;
  signal.half_length = 2;
  const auto set = [&](const int(&taps)[5]) {
    for (int k = 0; k < 5; ++k) signal.tap[k] = Tap::from_raw(taps[k] * (1 << 28));
  };
  const int shifts[] = {28, 31, 32, 33, 34}, evens[] = {90, 11, 6, 3, 1}, odds[] = {46, 6, 3, 1, 1};
  for (int i = 0; i < 5; ++i) {
    signal.shift = static_cast<uint8_t>(shifts[i]);
    set(even);
    EXPECT_EQ(even_signal(signal, &x[2]).raw, evens[i]) << shifts[i];
    for (int parity : {0, 1}) EXPECT_EQ(filter_signal(signal, &x[2], parity).raw, evens[i]) << shifts[i];
    set(odd);
    EXPECT_EQ(odd_signal(signal, &x[2]).raw, odds[i]) << shifts[i];
    for (int parity : {0, -1}) EXPECT_EQ(filter_signal(signal, &x[2], parity).raw, odds[i]) << shifts[i];
  }
}

}  // namespace
