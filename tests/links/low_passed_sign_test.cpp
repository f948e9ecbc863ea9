// The filtered sign against the sum written out tap by tap, over blocks that overlap as the energy sums ask for them.
#include "firmware/links/low_passed_sign.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <random>
#include <vector>

namespace {

using firmware::Code;
using firmware::Column;
using firmware::PassedSign;

constexpr int kAdvance = 32, kLength = kAdvance + 3, kBlocks = 20;
constexpr int kOne = 1 << PassedSign::kFractionBits;

struct Stream {
  std::vector<int> sign;
  std::vector<bool> known;
};

// hold: mean number of samples until the sign changes. Before the stream: no motion, nothing known.
Stream stream(int taps, double hold, unsigned seed) {
  Stream made{std::vector<int>(static_cast<size_t>(taps), 0), std::vector<bool>(static_cast<size_t>(taps), false)};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> chance;
  int sign = 1;
  for (int n = 0; n < kBlocks * kAdvance + kLength; ++n) {
    if (chance(random) < 1.0 / hold) sign = static_cast<int>(3.0 * chance(random)) - 1;
    made.sign.push_back(sign);
    made.known.push_back(chance(random) > 0.3 / hold);
  }
  return made;
}

// newest: place in the stream of the window's last sample.
void expect_written_out(const Stream& s, const std::vector<int>& tap, size_t newest, int32_t passed, int most_unknown,
                        bool clear) {
  int64_t sum = 0, unknown = 0;
  for (size_t k = 0; k < tap.size(); ++k) {
    const size_t at = newest + 1 - tap.size() + k;
    sum += int64_t{tap[k]} * s.sign[at];
    if (!s.known[at]) unknown += std::abs(tap[k]);
  }
  EXPECT_EQ(passed, sum) << "sample " << newest;
  EXPECT_EQ(clear, unknown <= most_unknown) << "sample " << newest;
}

// measured: a quarter of the weight may be unknown, else 1/32.
void run(int half, double hold, bool measured, unsigned seed) {
  const auto configuration = std::make_unique<firmware::CoreConfiguration>();
  configuration->sign_half_length = static_cast<uint8_t>(half);
  std::vector<int> tap;
  std::mt19937 random(seed);
  for (int k = 0; k < 2 * half + 1; ++k) {
    tap.push_back(static_cast<int>(random() % 120000) - 30000);  // of either sign, no symmetry
    configuration->sign_tap[k] = PassedSign::from_raw(tap.back());
  }
  const Stream s = stream(2 * half + 1, hold, seed);
  firmware::LowPassedSign filter;
  filter.restart();
  const size_t first = tap.size();
  for (int block = 0; block < kBlocks; ++block) {
    const size_t start = first + static_cast<size_t>(block * kAdvance);
    int32_t sign[kLength], passed[kLength];
    bool clear[kLength];
    for (int i = 0; i < kLength; ++i)
      sign[i] = s.sign[start + static_cast<size_t>(i)], clear[i] = s.known[start + static_cast<size_t>(i)];
    filter.fill(*configuration, measured, 0, kLength, kAdvance, Column<Code>(sign), Column<PassedSign>(passed), clear);
    for (int i = 0; i < kLength; ++i)
      expect_written_out(s, tap, start + static_cast<size_t>(i), passed[i], kOne / (measured ? 4 : 32), clear[i]);
  }
}

TEST(LowPassedSign, IsTheSumTapByTap) {
  for (const int half : {1, 5, firmware::kSignFilterHalf})
    for (const double hold : {1.0, 4.0, 30.0})
      for (const bool measured : {false, true})
        run(half, hold, measured, static_cast<unsigned>(half * 100) + static_cast<unsigned>(hold));
}

}  // namespace
