// The step of a coarse converter, read off its values.
#include "host_sim/records/steps/value_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using host_sim::value_step;

// 2000 samples of a swing of 0.3 about zero, 40 a period, in steps of `step` (0: none); every `full`th one is written in full.
std::vector<double> swing(double step, int full) {
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) {
    const double x = 0.3 * std::exp(-5e-4 * i) * std::sin(0.1571 * i);
    values.push_back(step == 0 || (full > 0 && i % full == 0) ? x : step * std::round(x / step));
  }
  return values;
}

TEST(ValueStep, IsTheGridOfAllValues) {
  EXPECT_NEAR(value_step(swing(0.01, 0)), 0.01, 1e-6);
  EXPECT_NEAR(value_step(swing(0.002, 0)), 0.002, 1e-7);
  EXPECT_EQ(value_step({1, 2, 1, 2}), 0.0);  // too few to say
}

TEST(ValueStep, IsThatOfMostValuesBesideAFewInFull) {
  // one in 100: two of a hundred steps are not whole. One in ten: twenty of a hundred.
  EXPECT_NEAR(value_step(swing(0.05, 100)), 0.05, 1e-4);
  EXPECT_EQ(value_step(swing(0.05, 10)), 0.0);
}

// A decay of 7 to 2 steps of 0.01, 600 samples a period, in which every so many of the values below half a step are written in full, each
// with a step of its own before and behind it. Of every fourth 41 of 100 steps are whole, and 98 of 100 values; of all of them 18 and 92.
std::vector<double> full_near_zero(size_t every) {
  std::vector<double> values;
  for (int i = 0; i < 20000; ++i) {
    const double x = 0.07 * std::exp(-6e-5 * i) * std::sin(2 * M_PI / 600 * i), rounded = 0.01 * std::round(100 * x);
    const bool in_full = rounded == 0.0 && static_cast<size_t>(i) % every == 0;
    values.push_back(in_full ? 1e-6 * std::round(1e6 * x) : rounded);
  }
  return values;
}

TEST(ValueStep, IsThatOfMostValuesWhereSmallOnesAreInFull) {
  EXPECT_NEAR(value_step(full_near_zero(4)), 0.01, 1e-6);
  EXPECT_EQ(value_step(full_near_zero(1)), 0.0);  // 8 of 100 values are off the grid
}

// 3960 counts a turn, written in hundredths of a degree: steps of 0.09 and 0.10, of 0.18 and 0.19. A hundredth is not the
// step: the swing rests on each value until it is a whole count away.
TEST(ValueStep, IsThatOfACounterWrittenInDecimals) {
  std::vector<double> values;
  for (double x : swing(0, 0)) values.push_back(0.01 * std::round(100.0 * std::round(60.0 * x * 11) / 11));
  EXPECT_NEAR(value_step(values), 1.0 / 11, 1e-3);
  for (double& value : values) value *= M_PI / 180;
  EXPECT_NEAR(value_step(values), M_PI / 180 / 11, 2e-5);
}

TEST(ValueStep, IsNoneOfASmoothSignalNorOfNoise) {
  EXPECT_EQ(value_step(swing(0.0, 0)), 0.0);
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> noise(5000);
  for (double& value : noise) value = normal(random);
  EXPECT_EQ(value_step(noise), 0.0);
}

// The smallest steps are a few codes then, and nothing but the codes themselves lies between two of them.
TEST(ValueStep, IsNoneOfNoiseInFineCodes) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  for (const double codes : {3e4, 3e5, 3e6}) {
    std::vector<double> values;
    for (int i = 0; i < 20000; ++i) values.push_back(std::round(codes * normal(random)) / 0x1p23);
    EXPECT_EQ(value_step(values), 0.0) << codes;
  }
}

// 1/11 degree in thousandths: steps of 0.091 and 0.090, of 0.182 and 0.181, and of many counts where the swing is fast.
TEST(ValueStep, IsThatOfACounterAmongFastSteps) {
  std::vector<double> values;
  for (int i = 0; i < 20000; ++i)
    values.push_back(std::round(std::round(11.0 * 40.0 * std::sin(0.02 * i)) / 11.0 * 1e3) / 1e3);
  EXPECT_NEAR(value_step(values), 1.0 / 11.0, 1e-4);
}

// A command of ramps: its steps are alike where it moves evenly, and any where it turns.
TEST(ValueStep, OfRampsThatTurnSmoothlyIsNone) {
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) {
    const double phase =
        std::fmod(0.01 * i, 4.0);  // a second to and a second fro, each followed by a second of turning
    values.push_back(phase < 1   ? phase
                     : phase < 2 ? 1 + std::sin(M_PI * (phase - 1)) / M_PI
                     : phase < 3 ? 3 - phase
                                 : -std::sin(M_PI * (phase - 3)) / M_PI);
  }
  EXPECT_EQ(value_step(values), 0.0);
}

// What the steps are counts, not where they stand: a counter's beside one step a thousand times smaller, and steps that differ in
// their last bits alone.
TEST(ValueStep, DoesNotDependOnTheOrderOfTheSteps) {
  std::mt19937 random(9);
  std::vector<double> counter, alike = {std::ldexp(1.0, -20)};
  for (int i = 0; i < 6000; ++i) {
    const double between = static_cast<double>(random() % 1000) / 1000.0;  // 9 or 10, 18 or 19, 27 or 28, 36 or 37 ...
    counter.push_back(std::floor(100.0 / 11 * static_cast<double>(1 + random() % 30) + between));
    alike.push_back(1.0 + std::ldexp(static_cast<double>(random() % 4096), -40));
  }
  const auto step_of = [](const std::vector<double>& steps) {
    std::vector<double> values = {0.0};  // to and fro, so that each step comes out of the difference as it went in
    for (size_t i = 0; i < steps.size(); ++i) {
      values.push_back(steps[i]);
      values.push_back(0.0);
    }
    return value_step(values);
  };
  for (std::vector<double>* steps : {&counter, &alike}) {
    std::sort(steps->begin(), steps->end());
    const double sorted = step_of(*steps);
    for (int turn = 0; turn < 3; ++turn) {
      std::shuffle(steps->begin(), steps->end(), random);
      EXPECT_NEAR(step_of(*steps), sorted, 1e-9 * sorted);
    }
  }
  EXPECT_NEAR(step_of(counter), 100.0 / 11, 0.01);
}

}  // namespace
