// host_sim estimate on accelerometers.
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;
using test_support::row;

// a = -(k x + c v) / m of the same decay, read by an accelerometer that stands in gravity: 0.45 g at rest.
TEST_F(Estimate, ComparesAnAccelerometerWithoutItsZero) {
  std::string with = "t_s,displacement_1_m,velocity_1_m_s,acceleration_1_m_s2\n", alone = "t_s,acceleration_1_m_s2\n";
  const double d = 1.5 / 4.0, w = std::sqrt(400.0 - d * d);
  for (int i = 0; i < 20000; ++i) {
    const double t = i * 1e-3, e = 0.01 * std::exp(-d * t), x = e * std::cos(w * t),
                 v = -e * (d * std::cos(w * t) + w * std::sin(w * t)), a = 4.41 - (800.0 * x + 1.5 * v) / 2.0;
    with += row({t, x, v, a}), alone += row({t, a});
  }
  workspace_.write("with.csv", with);
  const auto both = host_sim({"estimate", "--rig", "rig.toml", "--data", "with.csv", "--json", "with.json"});
  ASSERT_EQ(both.status, 0) << both.errors;
  EXPECT_LT(json("with.json")["mse_percent"][0].get<double>(), 1e-3);
  EXPECT_NEAR(value(json("with.json"), "viscous[1-0]"), 1.5, 1.5e-4);
  EXPECT_EQ(json("with.json")["parameters"][0]["status"], "VALID");  // the zero is no constant force
  EXPECT_NE(both.output.find("reads 4.41 at rest"), std::string::npos) << both.output;
  // accelerations do not tell where the decay begins: no number, and why
  workspace_.write("alone.csv", alone);
  const auto one = host_sim({"estimate", "--rig", "rig.toml", "--data", "alone.csv", "--json", "alone.json"});
  ASSERT_EQ(one.status, 0) << one.errors;
  EXPECT_NEAR(value(json("alone.json"), "viscous[1-0]"), 1.5, 0.015);
  EXPECT_TRUE(json("alone.json")["mse_percent"][0].is_null());
  EXPECT_NE(json("alone.json")["mse_note"].get<std::string>().find("diagnose"), std::string::npos);
  const auto fitted = host_sim({"diagnose", "--rig", "rig.toml", "--data", "alone.csv", "--json", "diagnosis.json"});
  ASSERT_EQ(fitted.status, 0) << fitted.errors;
  EXPECT_LT(json("diagnosis.json")["baseline"]["holdout_mse_percent"][0].get<double>(), 1e-2);
}

// A mass of 2 kg on 800 N/m and 1.5 N s/m, 3.2 Hz, under 40 cosines from 1.3 to 6.5 Hz, each steady: the force and its acceleration at
// -w^2 / (k - m w^2 + i c w). 36 s of it at 80 Hz, with time written as it is or in 1 / faster of it: then k and c are those of
// units of that time.
std::string driven_accelerometer(double faster) {
  constexpr int kLines = 40, kSamples = 2880;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> phase(0.0, 2 * M_PI);
  std::vector<double> force(kSamples, 0.0), acceleration(kSamples, 0.0);
  for (int line = 0; line < kLines; ++line) {
    const double w = 2 * M_PI * (1.3 + 5.2 * line / kLines), start = phase(random);
    const double real = 800.0 - 2.0 * w * w, imaginary = 1.5 * w, size = w * w / std::hypot(real, imaginary);
    for (int i = 0; i < kSamples; ++i) {
      const double turn = w * i / 80.0 + start;
      force[static_cast<size_t>(i)] += std::cos(turn);
      acceleration[static_cast<size_t>(i)] -= size * std::cos(turn - std::atan2(imaginary, real));
    }
  }
  std::normal_distribution<double> noise(0.0, 0.002);
  std::string text = "t_s,force_1_N,acceleration_1_m_s2\n";
  for (size_t i = 0; i < kSamples; ++i) {
    const double reads = acceleration[i] + noise(random), pushes = force[i] + noise(random);
    text += row({static_cast<double>(i) / 80.0 / faster, pushes * faster * faster, reads * faster * faster});
  }
  return text;
}

// A corner in hertz is passed by all that a fast rig does within a record of a second, and no window closed.
TEST_F(Estimate, AFastRigOnAnAccelerometerIsTheSlowOneInOtherUnitsOfTime) {
  for (const double faster : {1.0, 40.0, 400.0}) {
    char rig[200];
    std::snprintf(rig, sizeof rig,
                  "schema = \"rig/1\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = %.9g\n"
                  "viscous_N_s_m = \"estimate\"\n",
                  800.0 * faster * faster);
    workspace_.write("fast.toml", rig);
    workspace_.write("fast.csv", driven_accelerometer(faster));
    const auto result = host_sim({"estimate", "--rig", "fast.toml", "--data", "fast.csv", "--json", "out.json"});
    ASSERT_EQ(result.status, 0) << result.errors;
    const auto out = json("out.json");
    EXPECT_EQ(out["parameters"][0]["status"], "VALID") << faster << result.output;
    EXPECT_NEAR(value(out, "viscous[1-0]"), 1.5 * faster, 0.03 * faster);
  }
}

// A decay of 0.2 s on an accelerometer of 200 steps, in a record of 8 s. From its beginning the windows would open when it is over, on what
// the high-pass makes of a start that nobody knows: a damper of its time constant (0.16 s) times k, 130 N s/m for 20. From its end they
// hold the decay.
TEST_F(Estimate, AShortDecayIsSeenFromItsEnd) {
  constexpr double kMass_kg = 2.0, kStiffness_N_m = 800.0 * 16, kViscous_N_s_m = 20.0, kStep_m_s2 = 0.5;
  const double d = kViscous_N_s_m / (2 * kMass_kg), w = std::sqrt(kStiffness_N_m / kMass_kg - d * d);
  std::string text = "t_s,acceleration_1_m_s2\n";
  for (int i = 0; i < 4000; ++i) {
    const double t = i * 2e-3, e = 0.01 * std::exp(-d * t), x = e * std::cos(w * t),
                 v = -e * (d * std::cos(w * t) + w * std::sin(w * t));
    const double a = -(kStiffness_N_m * x + kViscous_N_s_m * v) / kMass_kg;
    text += row({t, kStep_m_s2 * std::round(a / kStep_m_s2)});
  }
  workspace_.write("blow.csv", text);
  workspace_.write("stiff.toml",
                   "schema = \"rig/1\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = 12800.0\n"
                   "viscous_N_s_m = \"estimate\"\n");
  const auto result = host_sim({"estimate", "--rig", "stiff.toml", "--data", "blow.csv", "--json", "out.json"});
  EXPECT_EQ(result.status, 0) << result.errors;
  const auto out = json("out.json");
  EXPECT_EQ(out["parameters"][0]["status"], "VALID") << result.output;
  EXPECT_NEAR(value(out, "viscous[1-0]"), 20.0, 3.0 * out["parameters"][0]["std"].get<double>());
  EXPECT_LT(out["parameters"][0]["std"].get<double>(), 1.0);
}

// Integrated accelerations settle first: no window closes within 1.2 s, four periods, and nothing is a number or tested.
TEST_F(Estimate, AccelerationsTooShortForAWindowCannotAnswer) {
  std::string text = "t_s,acceleration_1_m_s2\n";
  for (int i = 0; i < 1200; ++i) text += row({i * 1e-3, -4.0 * std::exp(-0.375e-3 * i) * std::cos(20e-3 * i)});
  workspace_.write("short.csv", text);
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "short.csv", "--json", "out.json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.errors.find("no window closed: a motion that is integrated"), std::string::npos) << result.errors;
  EXPECT_EQ(json("out.json")["parameters"][0]["status"], "STALE");
  EXPECT_TRUE(json("out.json")["mse_percent"][0].is_null());
}

}  // namespace
