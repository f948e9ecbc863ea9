// Filters of the wide band, and when they are taken.
#include "hal/rig_file/recorded/motion_band.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hal/rig_file/filter_design.hpp"

using rig_file::Band;

namespace {

// sum of h[k] f(k) at k = -half .. half, the oldest sample first.
template <typename Function>
double answer(const rig_file::Impulse& h, Function f) {
  const int half = static_cast<int>(h.size() / 2);
  double sum = 0;
  for (int k = -half; k <= half; ++k) sum += h[static_cast<size_t>(k + half)] * f(k);
  return sum;
}

// Eight points give (1/280, -4/105, 1/5, -4/5, 0, ...) and -205/72 in the middle of the second derivative, as every table has them.
TEST(CentralDifferences, OfEighthOrderAreTheTabulatedOnes) {
  const double first[] = {1.0 / 280, -4.0 / 105, 1.0 / 5, -4.0 / 5, 0.0, 4.0 / 5};
  const double second[] = {-1.0 / 560, 8.0 / 315, -1.0 / 5, 8.0 / 5, -205.0 / 72, 8.0 / 5};
  for (size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(rig_file::first_difference()[k], first[k], 1e-15);
    EXPECT_NEAR(rig_file::second_difference()[k], second[k], 1e-15);
  }
}

// The slope of sin(w k) at 0 is w, the second slope of cos(w k) there is -w^2; w of a fifth of the sample rate.
TEST(CentralDifferences, OfTheWideBandReachAFifthOfTheRate) {
  const double w = 2 * M_PI * 0.2;
  EXPECT_NEAR(answer(rig_file::first_difference(Band::kWide), [w](int k) { return std::sin(w * k); }) / w, 1.0, 1e-3);
  EXPECT_NEAR(answer(rig_file::second_difference(Band::kWide), [w](int k) { return std::cos(w * k); }) / (-w * w), 1.0,
              1e-4);
  EXPECT_LT(answer(rig_file::first_difference(), [w](int k) { return std::sin(w * k); }) / w, 0.995);  // eighth order
}

TEST(LowPass, OfTheWideBandPassesAFifthOfTheRate) {
  const auto wave = [](int k) { return std::cos(2 * M_PI * 0.2 * k); };
  EXPECT_NEAR(answer(rig_file::low_pass(0.0, Band::kWide), wave), 1.0, 0.01);
  EXPECT_LT(answer(rig_file::low_pass(0.0), wave), 0.1);
}

// Displacements of 10000 codes at 0.03 of the rate and `fast` codes at 0.2 of it, with 100 codes of white noise. The fast part has
// (0.2 / 0.03 fast / 10000)^2 of the slow one's rate power: 0.04 % for 30 codes, 4.4 % for 315.
TEST(MotionBand, IsWideWhereAHundredthOfTheRatesPowerIsBeyondATenth) {
  for (const double fast : {0.0, 30.0, 315.0}) {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 100.0);
    std::vector<firmware::RawSample> record(8000);
    for (size_t n = 0; n < record.size(); ++n) {
      const double t = static_cast<double>(n);
      record[n].code[0][1] = static_cast<int32_t>(
          std::lround(10000 * std::sin(2 * M_PI * 0.03 * t) + fast * std::sin(2 * M_PI * 0.2 * t) + noise(random)));
    }
    EXPECT_EQ(rig_file::moves_beyond_a_tenth({record}, 0, 1, {100.0, 0.0, 0.04, {}}), fast > 100) << fast;
  }
}

}  // namespace
