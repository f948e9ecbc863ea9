// Power spectra: of a tone by hand, and the same bits whoever else asks for others at the same time.
#include "host_sim/data_check/measures/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

namespace {

using host_sim::data_check::power_spectrum;

constexpr double kPi = 3.14159265358979323846;

std::vector<double> tone(size_t n, double cycles) {
  std::vector<double> values(n);
  for (size_t i = 0; i < n; ++i)
    values[i] = 2.0 + 3.0 * std::cos(2.0 * kPi * cycles * static_cast<double>(i) / static_cast<double>(n));
  return values;
}

// Under a Hann window a tone of amplitude 3 in bin 10 is 3 n / 4 there and half of that beside it.
TEST(Spectrum, OfATone) {
  const size_t n = 480;
  const std::vector<double> power = power_spectrum(tone(n, 10.0).data(), n, 2.0);
  ASSERT_EQ(power.size(), n / 2 + 1);
  EXPECT_NEAR(power[10], 360.0 * 360.0, 1e-6);
  EXPECT_NEAR(power[9], 180.0 * 180.0, 1e-6);
  EXPECT_NEAR(power[11], 180.0 * 180.0, 1e-6);
  EXPECT_NEAR(power[20], 0.0, 1e-9);
}

// More lengths than are kept, from several threads: plans are made and dropped beside each other.
TEST(Spectrum, IsTheSameFromManyThreads) {
  const std::vector<size_t> lengths = {64, 90, 100, 128, 210, 256, 480, 1000};
  std::vector<std::vector<double>> alone;
  for (const size_t n : lengths) alone.push_back(power_spectrum(tone(n, 7.3).data(), n, 2.1));
  std::vector<std::thread> threads;
  std::vector<int> differences(4, 0);
  for (size_t t = 0; t < differences.size(); ++t)
    threads.emplace_back([&, t] {
      for (size_t turn = 0; turn < 200; ++turn) {
        const size_t which = (turn * (2 * t + 1) + t) % lengths.size(), n = lengths[which];
        differences[t] += power_spectrum(tone(n, 7.3).data(), n, 2.1) != alone[which] ? 1 : 0;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(differences, std::vector<int>(4, 0));
}

}  // namespace
