// A first-order high-pass of a channel, undone.
#include "host_sim/records/ac_coupling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "hal/rig_file/toml/rig_writer.hpp"

namespace {

constexpr double kTwoPi = 6.283185307179586, kStep_s = 1e-3;

// sin(wt) behind jw / (jw + wc) in the steady state: g sin(wt + p), tan p = wc / w, g = cos p.
std::vector<double> behind(double corner_Hz, double tone_Hz, size_t samples) {
  const double phase = std::atan2(corner_Hz, tone_Hz);
  std::vector<double> y;
  for (size_t i = 0; i < samples; ++i)
    y.push_back(std::cos(phase) * std::sin(kTwoPi * tone_Hz * kStep_s * static_cast<double>(i) + phase));
  return y;
}

double worst(const std::vector<double>& y, double tone_Hz) {
  double most = 0.0;
  for (size_t i = 0; i < y.size(); ++i)
    most = std::max(most, std::abs(y[i] - std::sin(kTwoPi * tone_Hz * kStep_s * static_cast<double>(i))));
  return most;
}

}  // namespace

// At 8 Hz a corner of 1 Hz is 7 degrees of phase. Left: the trapezoid's (wT)^2 / 12 of an eighth, and what a parabola over 80
// periods takes of the integral.
TEST(AcCoupling, IsUndone) {
  const std::vector<double> y = behind(1.0, 8.0, 10000);
  EXPECT_GT(worst(y, 8.0), 0.1);
  EXPECT_LT(worst(host_sim::before_ac_coupling(y, 1.0, kStep_s), 8.0), 0.004);
}

// The integral of a sensor's zero and of its drift would grow without end: 0.1 over 10 s behind 1 Hz to 6.
TEST(AcCoupling, LeavesZeroAndDriftAsTheyAre) {
  std::vector<double> y = behind(1.0, 8.0, 10000);
  for (size_t i = 0; i < y.size(); ++i) y[i] += 0.1 + 0.05 * (static_cast<double>(i) / 5000.0 - 1.0);
  const std::vector<double> before = host_sim::before_ac_coupling(y, 1.0, kStep_s);
  EXPECT_LT(worst(before, 8.0), 0.17);
}

TEST(AcCoupling, OfTheChannelsThatTheRigFileStates) {
  const char* const kRig =
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 1\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = 1\nviscous_N_s_m = "
      "\"estimate\"\n[[channel]]\nname = \"acceleration_1_m_s2\"\nac_coupling_Hz = 0.25\n";
  const rig_file::RigModel rig = rig_file::parse_rig(kRig, "rig.toml");
  EXPECT_EQ(rig_file::parse_rig(rig_file::format_rig(rig), "again.toml").channels.at(0).ac_coupling_Hz, 0.25);
  const std::vector<host_sim::AcCoupling> stated = host_sim::stated_ac_couplings(rig);
  ASSERT_EQ(stated.size(), 1u);
  EXPECT_EQ(stated[0].corner_Hz, 0.25);
  std::vector<host_sim::Record> records(1);
  records[0].sample_period_s = kStep_s;
  const std::vector<double> y = behind(0.25, 8.0, 2000);
  records[0].channels = {{"force_1_N", host_sim::Quantity::kForce, 1, y},
                         {"acceleration_1_m_s2", host_sim::Quantity::kAcceleration, 1, y}};
  host_sim::undo_ac_coupling(stated, records);
  EXPECT_EQ(records[0].channels[0].values, y);
  EXPECT_EQ(records[0].channels[1].values, host_sim::before_ac_coupling(y, 0.25, kStep_s));
}
