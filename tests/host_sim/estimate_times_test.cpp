// host_sim estimate on times that are uneven, late or few.
#include <cmath>
#include <random>
#include <sstream>

#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;
using estimate_test::free_decay;
using estimate_test::kRig;
using test_support::row;

// A logger that comes late at times, and pauses: samples at uneven times, and 40 that are missing.
TEST_F(Estimate, TakesUnevenTimesWhereAskedTo) {
  const double d = 1.5 / 4.0, w = std::sqrt(400.0 - d * d);
  std::mt19937 random(3);
  std::string text = "t_s,displacement_1_m,velocity_1_m_s\n";
  for (int i = 0; i < 4000; ++i) {
    const double late_s = random() % 100 == 0 ? 4e-4 : 0.0, t = i * 1e-3 + late_s, e = 0.01 * std::exp(-d * t);
    if (i >= 2000 && i < 2040) continue;
    text += row({t, e * std::cos(w * t), -e * (d * std::cos(w * t) + w * std::sin(w * t))});
  }
  workspace_.write("late.csv", text);
  const auto refused = host_sim({"estimate", "--rig", "rig.toml", "--data", "late.csv"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("--resample 1000"), std::string::npos) << refused.errors;
  const auto result =
      host_sim({"estimate", "--rig", "rig.toml", "--data", "late.csv", "--resample", "1000", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.errors.find("in 2 parts between gaps"), std::string::npos) << result.errors;
  EXPECT_NEAR(value(json("out.json"), "viscous[1-0]"), 1.5, 1.5e-3);
}

// More finely than any of its files a record has nothing but interpolation, whose errors a right rig would have to answer for.
TEST_F(Estimate, NoFinerThanItWasMeasured) {
  workspace_.write("decay.csv", free_decay(4000));
  const auto run = [&](const char* rate) {
    return host_sim({"estimate", "--rig", "rig.toml", "--data", "decay.csv", "--resample", rate});
  };
  EXPECT_EQ(run("1100").status, 0);
  const auto refused = run("4000");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("has 1000 samples a second; at 4000 there would be interpolation alone"),
            std::string::npos)
      << refused.errors;
}

// A decay of 20 rad/s (3.2 Hz) is none of 7 Hz.
TEST_F(Estimate, AFrequencyThatTheMotionHasNotIsSaid) {
  workspace_.write("decay.csv", free_decay(4000));
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "decay.csv", "--frequency", "7"});
  EXPECT_NE((result.output + result.errors).find("--frequency says 7 Hz"), std::string::npos)
      << result.output << result.errors;
}

// A displacement late by 400 us against the velocity adds k tau = 0.32 to the damper, until the rig file says so.
TEST_F(Estimate, SkewIsTakenAwayByTheChannelsDelay) {
  workspace_.write("late.csv", free_decay(4000, 400e-6));
  workspace_.write("told.toml", kRig + std::string("[[channel]]\nname = \"displacement_1_m\"\ndelay_us = 400.0\n"));
  const auto told = host_sim({"estimate", "--rig", "told.toml", "--data", "late.csv", "--json", "told.json"});
  ASSERT_EQ(told.status, 0) << told.errors;
  EXPECT_NEAR(value(json("told.json"), "viscous[1-0]"), 1.5, 0.015);
}

// The highest of the tones has 13 samples a period. Late by 1.2 samples its acceleration is read as late by 1.2 sin(0.58) / 0.58 of them;
// a sample of what is left bends c by m w^2 of its time.
TEST_F(Estimate, ADelayOfMoreThanASampleIsTakenOutWhole) {
  constexpr double kHz[] = {1.1, 1.9, 2.3, 3.1}, kStep_s = 0.025;
  std::string text = "t_s,force_1_N,velocity_1_m_s,acceleration_1_m_s2\n";
  for (int i = 0; i < 8000; ++i) {
    double x = 0.0, v = 0.0, a = 0.0, late_a = 0.0;
    for (int k = 0; k < 4; ++k) {
      const double w = 2.0 * M_PI * kHz[k], phase = w * i * kStep_s + k * k;
      x += std::sin(phase) / w, v += std::cos(phase), a -= w * std::sin(phase);
      late_a -= w * std::sin(phase - 1.2 * w * kStep_s);
    }
    text += row({i * kStep_s, 2.0 * a + 400.0 * x + 3.0 * v, v, late_a});
  }
  workspace_.write("late.csv", text);
  workspace_.write("late.toml",
                   "schema = \"rig/1\"\nname = \"one\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\n"
                   "stiffness_N_m = 400.0\nviscous_N_s_m = \"estimate\"\n");
  const auto result = host_sim({"estimate", "--rig", "late.toml", "--data", "late.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_NEAR(value(json("out.json"), "viscous[1-0]"), 3.0, 0.03) << result.output;
  EXPECT_NE(result.output.find("late against the other channels of its DOF"), std::string::npos) << result.output;
}

// m = 1 kg, k = 80 N/m, c = 0.2 N s/m: 1.42 Hz, read every 2 ms as a displacement alone with 0.3 % noise, from a place 2.3 m away
// from the position of rest. At the full rate the noise of the second slope is 20 times the acceleration.
TEST_F(Estimate, ASlowMotionAboutAnArbitraryZeroTakesFewerSamples) {
  workspace_.write("slow.toml",
                   "schema = \"rig/1\"\nname = \"weight\"\n[[dof]]\nmass_kg = 1.0\n[[link]]\nbetween = [1, 0]\n"
                   "stiffness_N_m = \"estimate\"\nviscous_N_s_m = \"estimate\"\n");
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::string text = "t_s,displacement_1_m\n";
  const double d = 0.1, w = std::sqrt(80.0 - d * d);
  for (int i = 0; i < 10000; ++i) {
    const double t = 2e-3 * i;
    text += row({t, 2.3 + std::exp(-d * t) * std::cos(w * t) + 0.003 * normal(random)});
  }
  workspace_.write("slow.csv", text);
  const auto result = host_sim({"estimate", "--rig", "slow.toml", "--data", "slow.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto out = json("out.json");
  EXPECT_NEAR(value(out, "stiffness[1-0]"), 80.0, 0.4);
  EXPECT_NEAR(value(out, "viscous[1-0]"), 0.2, 0.04);
  for (const auto& parameter : out["parameters"]) EXPECT_EQ(parameter["status"], "VALID");
  EXPECT_NE(result.output.find("never comes to its zero"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("behind one low-pass for all channels"), std::string::npos) << result.output;
}

// The same at 29.4 Hz with 0.1 % noise. 0.001 of x in the second slope, over 588 samples, is 0.01 N/m of k.
TEST_F(Estimate, ADecayAtTwentySamplesAPeriodKnowsItsSpring) {
  workspace_.write("few.toml",
                   "schema = \"rig/1\"\n[[dof]]\nmass_kg = 1.0\n[[link]]\nbetween = [1, 0]\n"
                   "stiffness_N_m = \"estimate\"\nviscous_N_s_m = \"estimate\"\n");
  const double d = 0.1, w = std::sqrt(80.0 - d * d);
  int held = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::string text = "t_s,displacement_1_m\n";
    for (int i = 0; i < 588; ++i) {
      const double t = 0.034 * i;
      text += row({t, std::exp(-d * t) * std::cos(w * t) + 3.5e-4 * normal(random)});
    }
    workspace_.write("few.csv", text);
    const auto result = host_sim({"estimate", "--rig", "few.toml", "--data", "few.csv", "--json", "out.json"});
    ASSERT_EQ(result.status, 0) << result.errors << result.output;
    const auto spring = json("out.json")["parameters"][0];
    EXPECT_EQ(spring["status"], "VALID") << result.output;
    EXPECT_NEAR(spring["value"].get<double>(), 80.0, 0.02);
    held += spring["ci95"][0] <= 80.0 && spring["ci95"][1] >= 80.0 ? 1 : 0;
  }
  EXPECT_GE(held, 5);
}

// A knock on the cable in the first 50 ms of a decay of c = 1.5 N s/m.
TEST_F(Estimate, WhatLiesBeforeFromIsLeftOut) {
  std::istringstream lines(free_decay(4000));
  std::string text, line;
  for (int i = 0; std::getline(lines, line); ++i)
    text += i == 40 || i == 47 ? line.substr(0, line.find(',')) + ",0.4,0.3\n" : line + "\n";
  workspace_.write("knock.csv", text);
  const auto refused = host_sim({"estimate", "--rig", "rig.toml", "--data", "knock.csv"});
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.errors.find("spikes"), std::string::npos) << refused.errors;
  EXPECT_NE(refused.errors.find("--from"), std::string::npos) << refused.errors;
  const auto result =
      host_sim({"estimate", "--rig", "rig.toml", "--data", "knock.csv", "--from", "0.1", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_NEAR(value(json("out.json"), "viscous[1-0]"), 1.5, 0.002);
  EXPECT_NE(result.errors.find("taken from 0.1 to 3.999 s: 3900 of 4000 samples"), std::string::npos) << result.errors;
}

TEST_F(Estimate, FromLiesBeforeTo) {
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--from", "2", "--to", "1"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("--from has to lie before --to"), std::string::npos) << result.errors;
}

}  // namespace
