// Records that are sampled far more often than their motion needs, and what is differentiated of them.
#include "host_sim/programs/estimate/oversampling.hpp"

#include <cmath>
#include <cstdio>
#include <random>

#include "tests/host_sim/program_test.hpp"

namespace {

constexpr double kPeriod_s = 5e-4;

// Noise of 1e-3 beside a motion of 1 at 10 Hz: a tone of 10 Hz stands 60 dB above it, and its window reaches four bins of 1 Hz further.
TEST(Oversampling, TheMotionEndsWhereItsSpectrumMeetsTheNoise) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> tone(20000), noise(20000), drift(20000);
  for (size_t i = 0; i < tone.size(); ++i) {
    const double t_s = kPeriod_s * static_cast<double>(i);
    noise[i] = 1e-3 * normal(random);
    tone[i] = std::sin(2.0 * M_PI * 10.0 * t_s) + noise[i];
    drift[i] = tone[i] + 50.0 * t_s;
  }
  EXPECT_LT(host_sim::highest_motion_Hz(noise, kPeriod_s), 4.0);
  EXPECT_GE(host_sim::highest_motion_Hz(tone, kPeriod_s), 10.0);
  EXPECT_LT(host_sim::highest_motion_Hz(tone, kPeriod_s), 30.0);
  EXPECT_DOUBLE_EQ(host_sim::highest_motion_Hz(drift, kPeriod_s), host_sim::highest_motion_Hz(tone, kPeriod_s));
}

const char* const kRig =
    "schema = \"rig/1\"\nname = \"slide\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\n"
    "stiffness_N_m = 800.0\nviscous_N_s_m = \"estimate\"\n";

// 20 s at 2 kHz of five tones below 8 Hz, and the force that 2 kg, 800 N/m and 6 N s/m need for them. 0.1 % of noise: that of the slope
// over all 2 kHz is ten times the velocity.
std::string record(const char* columns, double acceleration) {
  constexpr double kHz[] = {1.1, 2.3, 3.7, 5.9, 7.3}, kAmplitude_m[] = {6e-3, 4e-3, 3e-3, 1.5e-3, 1e-3};
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::string text = columns;
  for (int i = 0; i < 40000; ++i) {
    double x = 0.0, v = 0.0, a = 0.0;
    for (int k = 0; k < 5; ++k) {
      const double w = 2.0 * M_PI * kHz[k], phase = w * i * kPeriod_s + k * k;
      x += kAmplitude_m[k] * std::sin(phase), v += kAmplitude_m[k] * w * std::cos(phase);
      a -= kAmplitude_m[k] * w * w * std::sin(phase);
    }
    char row[128];
    const int length = std::snprintf(row, sizeof row, "%.4f,%.9g,%.9g", i * kPeriod_s,
                                     2.0 * a + 800.0 * x + 6.0 * v + 0.004 * normal(random), x + 2e-5 * normal(random));
    if (acceleration != 0.0)
      std::snprintf(row + length, sizeof row - length, ",%.9g", a + acceleration * normal(random));
    text += std::string(row) + "\n";
  }
  return text;
}

class OversampledRecord : public test_support::ProgramTest {
 protected:
  void SetUp() override { workspace_.write("rig.toml", kRig); }
};

// All the information on 6 N s/m is below 8 Hz. From every twentieth sample on the interval is some hundredths wide; from every
// sample, with the noise up to 200 Hz in the derivatives, it is wider than 3.
TEST_F(OversampledRecord, GivesWhatItsMotionHolds) {
  workspace_.write("x.csv", record("t_s,force_1_N,displacement_1_m\n", 0.0));
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "x.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_NE(result.output.find("one is taken, behind one low-pass for all channels"), std::string::npos)
      << result.output;
  const auto out = json("out.json");
  const auto& viscous = out["parameters"][0];
  EXPECT_EQ(viscous["status"], "VALID") << result.output;
  EXPECT_NEAR(viscous["value"].get<double>(), 6.0, 4.0 * viscous["std"].get<double>());
  EXPECT_LT(viscous["std"].get<double>(), 0.06);
}

TEST_F(OversampledRecord, IsTakenAsItIsWhereNothingIsDifferentiated) {
  workspace_.write("xa.csv", record("t_s,force_1_N,displacement_1_m,acceleration_1_m_s2\n", 0.01));
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "xa.csv"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_EQ(result.output.find("one is taken"), std::string::npos) << result.output;
}

// A damper on a crank, without a mass that would smooth what friction does: 1830 N/m, 827 N s/m and 13.6 N at 1.37 Hz. A low-pass that
// left ten samples of a period rounded the jumps of friction so far that other laws were suspected.
TEST_F(OversampledRecord, OfADamperWithoutMassKeepsTheJumpsOfFriction) {
  constexpr double kAmplitude_m = 0.004, kOmega = 2 * M_PI * 1.37;
  workspace_.write("damper.toml",
                   "schema = \"rig/1\"\nname = \"damper\"\n[[dof]]\nmass_kg = 0\n[[link]]\nbetween = [1, 0]\n"
                   "stiffness_N_m = \"estimate\"\nviscous_N_s_m = \"estimate\"\ncoulomb_N = \"estimate\"\n");
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::string text = "t_s,force_1_N,displacement_1_m\n";
    for (int k = 0; k < 20000; ++k) {
      const double t_s = 1e-3 * k, x = kAmplitude_m * std::sin(kOmega * t_s),
                   v = kAmplitude_m * kOmega * std::cos(kOmega * t_s);
      char row[96];
      std::snprintf(row, sizeof row, "%.3f,%.9g,%.9g\n", t_s,
                    1830 * x + 827 * v + std::copysign(13.6, v) + 0.5 * normal(random),
                    x + kAmplitude_m / 5000 * normal(random));
      text += row;
    }
    workspace_.write("crank.csv", text);
    host_sim({"estimate", "--rig", "damper.toml", "--data", "crank.csv", "--json", "out.json"});
    const auto out = json("out.json");
    for (const auto& p : out["parameters"]) EXPECT_NE(p["status"], "MODEL_SUSPECT") << seed << p.dump();
    const auto& coulomb = out["parameters"][2];
    ASSERT_EQ(coulomb["name"], "coulomb[1-0]");
    EXPECT_NEAR(coulomb["value"].get<double>(), 13.6, 0.3) << seed;
  }
}

}  // namespace
