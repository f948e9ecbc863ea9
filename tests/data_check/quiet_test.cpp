// Sound records of every kind raise no doubt: made ones here, measured ones where they are.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/report/to_json.hpp"
#include "host_sim/ingestion/record_reader.hpp"
#include "host_sim/records/steps/value_step.hpp"
#include "host_sim/records/times/resample.hpp"
#include "tests/data_check/made_records.hpp"
#include "tests/host_sim/run_program.hpp"

namespace {

using host_sim::Channel;
using host_sim::Record;
using host_sim::data_check::check;
using host_sim::data_check::Report;
using host_sim::data_check::Weight;

std::string doubts(const Report& report) {
  std::string text;
  for (const std::string& line : host_sim::data_check::lines_of(report, Weight::kDoubt)) text += line + "\n";
  return text;
}

TEST(Quiet, OrdinaryRecordsOfEveryKind) {
  const rig_file::RigModel rig = made::chain();
  using made::Drive;
  for (const Drive drive : {Drive::kRandom, Drive::kTwoTones, Drive::kSweep, Drive::kHammer, Drive::kDecay,
                            Drive::kDecayToRest, Drive::kRelease})
    for (const char* sensors : {"xva", "x", "v", "a"})
      for (const double noise : {0.0, 1e-3, 0.05})
        for (const double encoder_m : {0.0, 2e-5, 1e-3}) {
          if (encoder_m > 0.0 && (noise > 0.0 || sensors[0] != 'x')) continue;
          made::Options options;
          options.drive = drive;
          options.sensors = sensors;
          options.noise = noise;
          options.duration_s = 12.0;
          options.encoder_m = encoder_m;
          options.seed = static_cast<unsigned>(drive) + 7;
          EXPECT_EQ(doubts(check({made::record(options)}, &rig)), "")
              << "drive " << static_cast<int>(drive) << " sensors " << sensors << " noise " << noise << " encoder "
              << encoder_m;
        }
}

TEST(Quiet, OtherRatesFrictionAndRigs) {
  for (const double rate_Hz : {200.0, 5000.0})
    for (const double friction_N : {0.0, 3.0}) {
      made::Options options;
      options.rate_Hz = rate_Hz;
      options.friction_N = friction_N;
      const rig_file::RigModel rig = made::chain();
      EXPECT_EQ(doubts(check({made::record(options)}, &rig)), "") << rate_Hz << " Hz, " << friction_N << " N";
    }
}

// The angle of a shaft that wanders slowly and trembles, read by an encoder of 8192 steps a turn under noise of a fifth of a step.
// Between its turns it never reads the same twice; at its farthest it stands still for as long as the turn is within one step.
TEST(Quiet, ACoarseEncoderStandsStillAtItsFarthest) {
  constexpr double kStep_rad = 2.0 * M_PI / 8192.0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Record record = made::record({});
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 0.2 * kStep_rad);
    std::vector<double>& angle = made::values(record, "displacement_1_m");
    for (size_t k = 0; k < angle.size(); ++k) {
      const double t = 0.001 * static_cast<double>(k) + 100.0 * seed;
      const double turned = 1.5 * std::sin(0.5 * t) + 0.8 * std::sin(1.3 * t) + 0.3 * std::sin(3.1 * t) +
                            0.02 * std::sin(21.0 * t) + noise(random);
      angle[k] = kStep_rad * std::nearbyint(turned / kStep_rad);
    }
    record.channels = {*record.find(host_sim::Quantity::kForce, 1), *record.find(host_sim::Quantity::kDisplacement, 1)};
    const std::string said = doubts(check({record}, nullptr));
    EXPECT_EQ(said.find("clipped"), std::string::npos) << "seed " << seed << ": " << said;
  }
}

// A pendulum's decay on a counter of 3960 steps a turn, written in hundredths of a degree: at its first and highest turn it
// stands on one value for a dozen samples, which are not clipped.
TEST(Quiet, ACounterWrittenInDecimalsTurnsAtItsFarthest) {
  made::Options five_seconds;
  five_seconds.duration_s = 5.0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    Record record = made::record(five_seconds);
    std::vector<double>& angle = made::values(record, "displacement_1_m");
    const double start_deg = 60.0 + 7.0 * seed;
    for (size_t k = 0; k < angle.size(); ++k) {
      const double t = 0.001 * static_cast<double>(k);
      const double deg = start_deg * std::exp(-0.08 * t) * std::cos(9.0 * t + 0.3);
      angle[k] = 0.01 * std::nearbyint(100.0 * std::nearbyint(deg * 11.0) / 11.0) * M_PI / 180.0;
    }
    record.channels = {*record.find(host_sim::Quantity::kDisplacement, 1)};
    EXPECT_EQ(doubts(check({record}, nullptr)), "") << "seed " << seed;
  }
}

// A table that is driven to its farthest place again and again, stops there by friction, rests and goes back, on an encoder of
// 1 um under noise of a fifth of that: flat for a quarter of the time, and its range does not end there.
TEST(Quiet, AStopInFrictionAtItsFarthest) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Record record = made::record({});
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 2e-7);
    std::vector<double>& place = made::values(record, "displacement_1_m");
    for (size_t k = 0; k < place.size(); ++k) {
      // Of 2 s: 0.5 s there, 0.5 s of rest, 0.5 s back, 0.5 s of rest; full speed at first, evenly slower until it stops.
      const double t = 1e-3 * static_cast<double>(k % 2000), s = std::min(1.0, std::fmod(t, 1.0) / 0.5);
      const double way = 2.0 * s - s * s;
      place[k] = 1e-6 * std::nearbyint((1e-3 * (t < 1.0 ? way : 1.0 - way) + noise(random)) / 1e-6);
    }
    record.channels = {*record.find(host_sim::Quantity::kForce, 1), *record.find(host_sim::Quantity::kDisplacement, 1)};
    const std::string said = doubts(check({record}, nullptr));
    EXPECT_EQ(said.find("clipped"), std::string::npos) << "seed " << seed << ": " << said;
  }
}

// An encoder of 0.002 rad on a swing of 1.6 rad that turns within 20 rad/s^2, read by a PC at uneven times: around each turn
// it stands on one step for sqrt(8 * 0.002 / 20) = 28 ms, 14 samples. Interpolated onto even steps these are tops of a channel
// whose steps no longer show; they were recorded in steps, and nothing is clipped.
TEST(Quiet, AnEncoderThatTurnsAndWasInterpolated) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> late_s(0.0, 3e-5);
    std::normal_distribution<double> shake(0.0, 1e-4);
    Record uneven;
    uneven.file = "swing.csv", uneven.sample_period_s = 0.002;
    Channel angle{"angle_1_rad", host_sim::Quantity::kDisplacement, 1, {}};
    for (size_t k = 0; k < 3000; ++k) {
      const double t = 0.002 * static_cast<double>(k) + late_s(random);
      const double place = 1.6 * std::exp(-0.1 * t) * std::cos(3.5 * t + 0.1 * seed) + shake(random);
      uneven.time_s.push_back(t);
      angle.values.push_back(0.002 * std::nearbyint(place / 0.002));
    }
    uneven.channels = {angle};
    const std::vector<Record> even = host_sim::resampled(uneven, 500.0);
    ASSERT_EQ(even.size(), 1u);
    EXPECT_NEAR(host_sim::value_step(even[0].channels[0]), 0.002, 1e-5);
    EXPECT_EQ(doubts(check(even, nullptr)), "") << "seed " << seed;
  }
}

// A motor at 50 samples a second, whose speed is what a counter adds in a sample, in steps of 2.35 rad/s: it follows the steps of its
// command within 0.1 s and runs on at one of a few speeds, on either side of a step by turns. The highest of them is no end of a range.
TEST(Quiet, ASpeedThatIsHeldOnACoarseCounter) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    Channel force{"torque_1_N_m", host_sim::Quantity::kForce, 1, {}},
        speed{"angular_velocity_1_rad_s", host_sim::Quantity::kVelocity, 1, {}};
    double v = 0.0, place = 0.0, command = 0.0;
    for (size_t k = 0; k < 4800; ++k) {
      if (k % 60 == 0) command = 55.0 + 8.3 * static_cast<double>(random() % 6);
      v += 0.2 * (command - v);
      const double before = std::floor(place / 2.35);
      place += v;
      force.values.push_back(0.05 * command), speed.values.push_back(2.35 * (std::floor(place / 2.35) - before));
    }
    Record record;
    record.file = "motor.csv", record.sample_period_s = 0.02, record.channels = {force, speed};
    const std::string said = doubts(check({record}, nullptr));
    EXPECT_EQ(said.find("clipped"), std::string::npos) << "seed " << seed << ": " << said;
  }
}

// A commanded sine of 250 samples a period, without noise: both samples at its top are alike to the last digit. So they are where
// it has 12 and 6 samples a period.
TEST(Quiet, ACommandedSineTurnsBetweenTwoSamples) {
  for (const double period : {250.0, 12.0, 6.0}) {
    Record record = made::record({});
    std::vector<double>& force = made::values(record, "force_1_N");
    for (size_t k = 0; k < force.size(); ++k)
      force[k] = 1e-10 * std::nearbyint(2.5e10 * std::sin(2.0 * M_PI * (static_cast<double>(k) + 0.5) / period));
    record.channels = {*record.find(host_sim::Quantity::kForce, 1), *record.find(host_sim::Quantity::kDisplacement, 1)};
    const std::string said = doubts(check({record}, nullptr));
    EXPECT_EQ(said.find("clipped"), std::string::npos) << period << " samples: " << said;
  }
}

// Two tones of 13 and 29 samples a period, a converter of 12 bits, noise of 1.4 %: tops of two samples are no flat stretch.
TEST(Quiet, TopsOfTwoSamplesAreNotFlat) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Record record = made::record({});
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 0.014);
    std::vector<double>& tones = made::values(record, "velocity_1_m_s");
    for (size_t k = 0; k < tones.size(); ++k) {
      const auto t = static_cast<double>(k);
      const double value =
          std::sin(2.0 * M_PI * t / 13.1 + seed) + 0.4 * std::sin(2.0 * M_PI * t / 29.3) + noise(random);
      tones[k] = 7e-4 * std::nearbyint(value / 7e-4);
    }
    tones.resize(2500);
    record.channels = {{"velocity_1_m_s", host_sim::Quantity::kVelocity, 1, tones}};
    const std::string said = doubts(check({record}, nullptr));
    EXPECT_EQ(said.find("clipped"), std::string::npos) << "seed " << seed << ": " << said;
  }
}

// A swing of eight samples a period that dies within two periods, then noise: its first crests are only three samples wide.
TEST(Quiet, ACrestOfFewSamplesIsNoSpike) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Record record = made::record({});
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 2e-3);
    for (const char* name : {"displacement_1_m", "velocity_1_m_s"}) {
      std::vector<double>& swing = made::values(record, name);
      for (size_t k = 0; k < swing.size(); ++k) {
        const double t = static_cast<double>(k) / 8.0;
        swing[k] = std::exp(-1.2 * t) * (1.0 - std::cos(2.0 * M_PI * t + 0.1 * seed)) +
                   0.3 * std::exp(-0.004 * t) * std::sin(0.7 * t) + noise(random);
      }
    }
    record.channels = {*record.find(host_sim::Quantity::kForce, 1), *record.find(host_sim::Quantity::kDisplacement, 1),
                       *record.find(host_sim::Quantity::kVelocity, 1)};
    const std::string said = doubts(check({record}, nullptr));
    EXPECT_EQ(said.find("spike"), std::string::npos) << "seed " << seed << ": " << said;
  }
}

// A force for 8 s of 16, then none; the swing it has left stops in friction at 11 s. From there on both sensors show their noise alone,
// the force no less of it than in the 3 s before. An accelerometer that fails beside a displacement that swings on is dead.
TEST(Quiet, ARigThatComesToRestBehindItsDriveIsNotDead) {
  std::mt19937 random(6);
  std::normal_distribution<double> noise(0.0, 0.01);
  Channel force{"force_1_N", host_sim::Quantity::kForce, 1, {}},
      acceleration{"acceleration_1_m_s2", host_sim::Quantity::kAcceleration, 1, {}},
      displacement{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, {}};
  for (int i = 0; i < 3200; ++i) {
    const double t = 0.005 * i, swing = std::cos(2 * M_PI * 1.5 * t), left = std::clamp((11 - t) / 3, 0.0, 1.0);
    force.values.push_back((t < 8 ? std::sin(2 * M_PI * 1.5 * t) : 0.0) + noise(random));
    acceleration.values.push_back(5 * left * swing + noise(random));
    displacement.values.push_back(-5 * swing + noise(random));
  }
  Record record;
  record.file = "stops.csv", record.sample_period_s = 0.005, record.channels = {force, acceleration};
  EXPECT_EQ(doubts(check({record}, nullptr)).find("stops for good"), std::string::npos);
  record.channels.push_back(displacement);
  EXPECT_NE(doubts(check({record}, nullptr)).find("stops for good"), std::string::npos);
}

// A rig file whose masses and springs are a third off is for the diagnosis to say, not for the check.
TEST(Quiet, AWrongRigFileIsNoFaultOfTheData) {
  for (const char* sensors : {"xva", "x", "a"})
    for (const double factor : {0.7, 1.4}) {
      made::Options options;
      options.sensors = sensors;
      rig_file::RigModel rig = made::chain();
      rig.links[0].stiffness_N_m.value *= factor;
      EXPECT_EQ(doubts(check({made::record(options)}, &rig)), "") << sensors << " " << factor;
      rig = made::chain();
      rig.dofs[1].mass_kg.value *= factor;
      EXPECT_EQ(doubts(check({made::record(options)}, &rig)), "") << sensors << " " << factor;
    }
}

// A fixed base, a force that only drives in one of two records.
TEST(Quiet, WhatIsRightlyConstant) {
  Record record = made::record({});
  record.channels.push_back({"displacement_base_m", host_sim::Quantity::kDisplacement, rig_file::kBase,
                             std::vector<double>(record.samples(), 0.0)});
  EXPECT_EQ(doubts(check({record}, nullptr)), "");
}

// Square waves and trapezoids as they are commanded: flat tops that are true.
TEST(Quiet, CommandedForcesHaveFlatTops) {
  Record record = made::record({});
  std::vector<double>& force = made::values(record, "force_1_N");
  for (size_t i = 0; i < force.size(); ++i) force[i] = (i / 500) % 2 == 0 ? 5.0 : -5.0;
  EXPECT_EQ(doubts(check({record}, nullptr)), "");
  for (size_t i = 0; i < force.size(); ++i) {
    const double phase = static_cast<double>(i % 1000) / 250.0;  // up, hold, down, hold
    force[i] = phase < 1 ? phase : phase < 2 ? 1.0 : phase < 3 ? 3.0 - phase : 0.0;
  }
  EXPECT_EQ(doubts(check({record}, nullptr)), "");
}

TEST(Quiet, MeasuredRecordings) {
  const std::filesystem::path shared = test_support::shared_folder();
  if (shared.empty() || !std::filesystem::exists(shared / "measured"))
    GTEST_SKIP() << "no measured recordings here (RIG_SHARED_DIR)";
  size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(shared / "measured")) {
    if (entry.path().extension() != ".csv") continue;
    ++count;
    const auto records = host_sim::read_records(entry.path().string(), rig_file::RigModel());
    EXPECT_EQ(doubts(check(records, nullptr)), "");
  }
  EXPECT_GT(count, 0u);
}

}  // namespace
