// Accelerometers behind a high-pass, told by what else the DOF has.
#include "host_sim/data_check/one_motion/coupling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hal/rig_file/channel_entry.hpp"
#include "host_sim/data_check/report/to_json.hpp"
#include "tests/data_check/made_records.hpp"
#include "tests/data_check/pass_high.hpp"

namespace {

using host_sim::Record;
using host_sim::data_check::Finding;

constexpr double kTwoPi = 6.283185307179586;

void pass_low(std::vector<double>& values, double corner_Hz, double step_s) {
  const double half = 0.5 * kTwoPi * corner_Hz * step_s;
  double before = values.front(), y = before;
  for (double& value : values) {
    y = ((1.0 - half) * y + half * (value + before)) / (1.0 + half);
    before = value, value = y;
  }
}

Record behind(double corner_Hz, const char* sensors, made::Drive drive, double noise, unsigned seed) {
  made::Options options;
  options.sensors = sensors, options.drive = drive, options.noise = noise, options.seed = seed;
  Record record = made::record(options);
  if (corner_Hz > 0.0) made::pass_high(made::values(record, "acceleration_1_m_s2"), corner_Hz, record.sample_period_s);
  return record;
}

void put_late(std::vector<double>& values, size_t samples) {
  values.insert(values.begin(), samples, values.front());
  values.resize(values.size() - samples);
}

TEST(Coupling, OfAnAccelerometerIsToldWithItsCornerAndKey) {
  for (const char* sensors : {"xa", "va", "xva"})
    for (const double corner_Hz : {0.1, 0.3, 1.0})
      for (const made::Drive drive : {made::Drive::kRandom, made::Drive::kHammer}) {
        const Record record = behind(corner_Hz, sensors, drive, 1e-3, 5);
        const std::vector<Finding> found = host_sim::data_check::find_ac_coupling(record, nullptr);
        ASSERT_EQ(found.size(), 1u) << sensors << " " << corner_Hz << " " << static_cast<int>(drive);
        EXPECT_EQ(found[0].channel, "acceleration_1_m_s2");
        EXPECT_NEAR(*found[0].value, corner_Hz, 0.05 * corner_Hz) << sensors;
        EXPECT_NE(found[0].detail.find("ac_coupling_Hz = "), std::string::npos) << found[0].detail;
      }
}

// What half a sample of a jump in every period makes is no corner: at 10 Hz and 1 kHz 3 % of the channel.
TEST(Coupling, WhereTonesDriveItHasToBeMoreThanHalfASample) {
  const Record record = behind(0.1, "xa", made::Drive::kRandom, 1e-3, 5);
  EXPECT_EQ(host_sim::data_check::find_ac_coupling(record, nullptr).size(), 1u);
  EXPECT_EQ(host_sim::data_check::find_ac_coupling(record, nullptr, 10.0).size(), 0u);
  const Record strong = behind(1.0, "xa", made::Drive::kRandom, 1e-3, 5);
  EXPECT_EQ(host_sim::data_check::find_ac_coupling(strong, nullptr, 10.0).size(), 1u);
}

TEST(Coupling, IsPartOfTheCheck) {
  const rig_file::RigModel rig = made::chain();
  const host_sim::data_check::Report report =
      host_sim::data_check::check({behind(0.3, "xa", made::Drive::kRandom, 1e-3, 2)}, &rig);
  EXPECT_STREQ(report.verdict(), "usable");
  std::string all;
  for (const std::string& line : host_sim::data_check::lines_of(report, host_sim::data_check::Weight::kDoubt))
    all += line;
  EXPECT_NE(all.find("acceleration_1_m_s2: ac_coupling: "), std::string::npos) << all;
}

// A stated corner has been undone by the reader: what is left belongs to the same key.
TEST(Coupling, WhatTheRigFileStatesIsAddedTo) {
  rig_file::RigModel rig = made::chain();
  rig_file::entry_to_write(rig, "acceleration_1_m_s2").ac_coupling_Hz = 0.2;
  const std::vector<Finding> found =
      host_sim::data_check::find_ac_coupling(behind(0.3, "xa", made::Drive::kRandom, 1e-3, 2), &rig);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(*found[0].value, 0.5, 0.02);
}

TEST(Coupling, SoundChannelsLateOnesAndNoisyOnesAreNone) {
  for (const made::Drive drive :
       {made::Drive::kRandom, made::Drive::kTwoTones, made::Drive::kSweep, made::Drive::kHammer, made::Drive::kDecay})
    for (const double noise : {0.0, 1e-3, 0.05})
      for (const char* late : {"", "displacement_1_m", "velocity_1_m_s", "acceleration_1_m_s2"})
        for (unsigned seed = 1; seed <= 3; ++seed) {
          Record record = behind(0.0, "xva", drive, noise, seed);
          if (*late != '\0') put_late(made::values(record, late), 4);
          const std::vector<Finding> found = host_sim::data_check::find_ac_coupling(record, nullptr);
          EXPECT_TRUE(found.empty()) << static_cast<int>(drive) << " " << noise << " " << late << " "
                                     << found[0].detail;
        }
}

// First-order filters that differ are no high-pass, however low they are.
TEST(Coupling, SlowFiltersOfOtherChannelsAreNone) {
  for (const char* slow : {"displacement_1_m", "velocity_1_m_s", "acceleration_1_m_s2"})
    for (const double corner_Hz : {10.0, 30.0, 100.0})
      for (unsigned seed = 1; seed <= 3; ++seed) {
        Record record = behind(0.0, "xva", made::Drive::kRandom, 1e-3, seed);
        pass_low(made::values(record, slow), corner_Hz, record.sample_period_s);
        const std::vector<Finding> found = host_sim::data_check::find_ac_coupling(record, nullptr);
        EXPECT_TRUE(found.empty()) << slow << " " << corner_Hz << " " << found[0].channel << found[0].detail;
      }
}

}  // namespace
