// Whether a drive has the frequency that it is said to have.
#include "host_sim/programs/estimate/drive_frequency.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using host_sim::Quantity;

constexpr double kTwoPi = 6.283185307179586;

// Sines of 5 Hz (amplitude 2) and 15 Hz (amplitude 1): 4 s at 1 kHz.
std::vector<double> drive() {
  std::vector<double> force;
  for (int k = 0; k < 4000; ++k) force.push_back(2.0 * std::sin(kTwoPi * 0.005 * k) + std::cos(kTwoPi * 0.015 * k));
  return force;
}

// Their powers are as 4 to 1: 5 Hz and its third harmonic hold it all, 15 Hz a fifth, 7 Hz (whose harmonics are 14 and 21 Hz) none
// to speak of; 0.1 Hz has no cycle in 4 s. 2 % off its
// own, a frequency slips by 0.16 cycles over eight and keeps sinc^2 0.16 = 0.92 of its 0.8, its third harmonic by 0.48 and keeps 0.44 of
// its 0.2: 0.82.
TEST(DriveFrequency, HoldsTheShareOfItsHarmonics) {
  EXPECT_NEAR(host_sim::share_at(drive(), 1e-3, 5.0), 1.0, 1e-9);
  EXPECT_NEAR(host_sim::share_at(drive(), 1e-3, 15.0), 0.2, 0.05);
  EXPECT_LT(host_sim::share_at(drive(), 1e-3, 7.0), 0.2);
  EXPECT_EQ(host_sim::share_at(drive(), 1e-3, 0.1), 0.0);
  EXPECT_NEAR(host_sim::share_at(drive(), 1e-3, 5.1), 0.82, 0.03);
}

// The drive is judged, not the motion: a displacement that swings at 7 Hz does not make 7 Hz right.
TEST(DriveFrequency, AnotherThanTheDrivesIsSaid) {
  std::vector<double> swing;
  for (int k = 0; k < 4000; ++k) swing.push_back(std::sin(kTwoPi * 0.007 * k));
  host_sim::Record record;
  record.file = "a.csv", record.sample_period_s = 1e-3;
  record.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, swing},
                     {"force_1_N", Quantity::kForce, 1, drive()}};
  EXPECT_TRUE(host_sim::doubt_frequency({record}, 5.0).empty());
  const auto notes = host_sim::doubt_frequency({record}, 7.0);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("a.csv"), std::string::npos) << notes[0];
  EXPECT_NE(notes[0].find("of the power of force_1_N lies there"), std::string::npos) << notes[0];
}

}  // namespace
