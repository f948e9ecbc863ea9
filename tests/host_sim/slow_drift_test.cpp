// Velocities and accelerations that drift, and what is integrated of them.
#include <cmath>
#include <cstdio>
#include <random>

#include "host_sim/programs/shared/slow_part.hpp"
#include "tests/host_sim/program_test.hpp"

namespace {

constexpr double kPeriod_s = 2e-3, kDuration_s = 40.0;
constexpr int kSamples = static_cast<int>(kDuration_s / kPeriod_s);

// 24 tones from 6 to 17.5 Hz of one size and unlike phases: the amplitude is that of their sum's rms.
double tones(double t_s) {
  double sum = 0.0;
  for (int k = 0; k < 24; ++k) sum += std::sin(2.0 * M_PI * (6.0 + 0.5 * k) * t_s + 0.7 * k * k);
  return sum / std::sqrt(12.0);
}
// One and two and a half periods of the record, 2 % of the tones.
double drift(double t_s) {
  return 0.02 * (std::sin(2.0 * M_PI * t_s / kDuration_s) + std::cos(5.0 * M_PI * t_s / kDuration_s));
}

std::vector<double> recorded(double slow, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values;
  for (int i = 0; i < kSamples; ++i) {
    const double t_s = kPeriod_s * i;
    values.push_back(tones(t_s) + slow * drift(t_s) + noise * normal(random));
  }
  return values;
}

// The means over nine bins of 0.025 Hz begin 0.1 Hz before the first tone, and Hann's window reaches two bins further.
TEST(SlowDrift, TheDriveBeginsAboveAGap) {
  EXPECT_NEAR(host_sim::lowest_drive_Hz(recorded(0.0, 0.01, 1), kPeriod_s), 5.85, 0.1);
  EXPECT_NEAR(host_sim::lowest_drive_Hz(recorded(1.0, 0.01, 2), kPeriod_s), 5.85, 0.1);
  // A fifth of the tones at the bottom of the spectrum drives too: it is 4 % of the power.
  EXPECT_EQ(host_sim::lowest_drive_Hz(recorded(10.0, 0.01, 3), kPeriod_s), 0.0);
}

// The faster of the two slow waves has 0.0625 Hz; its window reaches four bins further above 1 % of noise.
TEST(SlowDrift, EndsWhereItMeetsTheNoise) {
  const double end_Hz = host_sim::drift_end_Hz(recorded(1.0, 0.01, 4), kPeriod_s, 5.85, 0, 0.0);
  EXPECT_GT(end_Hz, 0.0625);
  EXPECT_LT(end_Hz, 0.25);
  for (unsigned seed = 5; seed < 25; ++seed)
    EXPECT_EQ(host_sim::drift_end_Hz(recorded(0.0, 0.01, seed), kPeriod_s, 5.85, 0, 0.0), 0.0) << seed;
}

// Of the tones' integral, some 11 Hz, half a percent of them at 0.05 Hz is as much: (11 / 0.05) * 0.005 = 1.1. A twentieth of that is nothing.
TEST(SlowDrift, CountsByWhatItMakesOfTheIntegral) {
  EXPECT_GT(host_sim::drift_end_Hz(recorded(0.25, 1e-4, 4), kPeriod_s, 5.85, 1, 1.0), 0.0);
  EXPECT_EQ(host_sim::drift_end_Hz(recorded(0.0125, 1e-4, 4), kPeriod_s, 5.85, 1, 1.0), 0.0);
  EXPECT_GT(host_sim::drift_end_Hz(recorded(0.0125, 1e-4, 4), kPeriod_s, 5.85, 2, 1.0), 0.0);
}

// Half periods k = 1 to 2 * 0.2 Hz * 40 s = 16 are gone; a tone of 8 Hz is what it was but for 1 / (8 Hz * 40 s) at the ends.
TEST(SlowDrift, TakesOffCosinesAndNoMore) {
  std::vector<double> values, tone;
  for (int i = 0; i < kSamples; ++i) {
    const double share = (i + 0.5) / kSamples;
    tone.push_back(std::sin(2.0 * M_PI * 8.0 * kPeriod_s * i));
    values.push_back(tone.back() + 3.0 * std::cos(M_PI * share) - 2.0 * std::cos(16.0 * M_PI * share) +
                     0.5 * std::cos(17.0 * M_PI * share));
  }
  host_sim::take_off_cosines(values, kPeriod_s, 0.2);
  for (int i = 0; i < kSamples; ++i) {
    const double left = tone[static_cast<size_t>(i)] + 0.5 * std::cos(17.0 * M_PI * (i + 0.5) / kSamples);
    ASSERT_NEAR(values[static_cast<size_t>(i)], left, 0.04) << i;
  }
}

// 2 kg on 8000 N/m and 6 N s/m, of which a velocity is recorded with 1 % of noise and with or without 2 % of drift: over 0.05 Hz that is as
// large as the displacement of 10 Hz is.
class DriftingVelocity : public test_support::ProgramTest {
 protected:
  void SetUp() override {
    workspace_.write("rig.toml",
                     "schema = \"rig/1\"\nname = \"slide\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\n"
                     "stiffness_N_m = 8000.0\nviscous_N_s_m = \"estimate\"\n");
  }
  struct Motion {
    double x = 0.0, v = 0.0, a = 0.0;
  };
  static Motion motion(double t_s) {
    Motion m;
    for (int k = 0; k < 24; ++k) {
      const double w = 2.0 * M_PI * (6.0 + 0.5 * k), phase = w * t_s + 0.7 * k * k;
      m.x += 1e-3 * std::sin(phase), m.v += 1e-3 * w * std::cos(phase), m.a -= 1e-3 * w * w * std::sin(phase);
    }
    return m;
  }
  std::string record(double slow) {
    std::mt19937 random(31);
    std::normal_distribution<double> normal;
    std::string text = "t_s,force_1_N,velocity_1_m_s\n";
    for (int i = 0; i < kSamples; ++i) {
      const double t_s = kPeriod_s * i;
      const auto [x, v, a] = motion(t_s);
      char row[96];
      std::snprintf(row, sizeof row, "%.3f,%.9g,%.9g\n", t_s, 2.0 * a + 8000.0 * x + 6.0 * v + 0.2 * normal(random),
                    v + 0.26 * (slow * drift(t_s) + 0.01 * normal(random)));
      text += row;
    }
    return text;
  }
};

TEST_F(DriftingVelocity, IsNotTakenForWhatTheRigLacks) {
  for (const double slow : {0.0, 1.0}) {
    workspace_.write("v.csv", record(slow));
    const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "v.csv", "--json", "out.json"});
    ASSERT_EQ(result.status, 0) << result.errors << result.output;
    EXPECT_EQ(result.output.find("Hz is taken off all channels") != std::string::npos, slow > 0.0) << result.output;
    const auto out = json("out.json");
    const auto& viscous = out["parameters"][0];
    EXPECT_EQ(viscous["status"], "VALID") << result.output;
    EXPECT_NEAR(viscous["value"].get<double>(), 6.0, 4.0 * viscous["std"].get<double>());
    EXPECT_LT(viscous["std"].get<double>(), 0.3);
  }
}

// The same rig with the force and 20 s of its displacement, which a sensor that warms up carries off by three times its rms, with a time
// constant of half the record.
class DriftingDisplacement : public DriftingVelocity {
 protected:
  std::string warm(double drift_m) {
    std::mt19937 random(32);
    std::normal_distribution<double> normal;
    std::string text = "t_s,force_1_N,displacement_1_m\n";
    for (int i = 0; i < kSamples / 2; ++i) {
      const double t_s = kPeriod_s * i;
      const auto [x, v, a] = motion(t_s);
      char row[96];
      std::snprintf(row, sizeof row, "%.3f,%.9g,%.9g\n", t_s, 2.0 * a + 8000.0 * x + 6.0 * v + 0.2 * normal(random),
                    x + drift_m * (1.0 - std::exp(-t_s / 10.0)) + 3.5e-6 * normal(random));
      text += row;
    }
    return text;
  }
};

TEST_F(DriftingDisplacement, PullsNoSpring) {
  for (const double drift_m : {0.0, 10e-3}) {
    workspace_.write("x.csv", warm(drift_m));
    const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "x.csv", "--json", "out.json"});
    ASSERT_EQ(result.status, 0) << result.errors << result.output;
    EXPECT_EQ(result.output.find("displacement_1_m drifts") != std::string::npos, drift_m > 0.0) << result.output;
    const auto estimated = json("out.json")["parameters"][0];
    EXPECT_EQ(estimated["status"], "VALID") << result.output;
    EXPECT_NEAR(estimated["value"].get<double>(), 6.0, 4.0 * estimated["std"].get<double>());
    EXPECT_LT(estimated["std"].get<double>(), 0.1);
    const auto diagnosed = host_sim({"diagnose", "--rig", "rig.toml", "--data", "x.csv", "--json", "out.json"});
    ASSERT_EQ(diagnosed.status, 0) << diagnosed.errors;
    EXPECT_EQ(json("out.json")["verdict"], "none") << diagnosed.output;
    EXPECT_EQ(diagnosed.errors.find("displacement_1_m drifts") != std::string::npos, drift_m > 0.0) << diagnosed.errors;
  }
}

}  // namespace
