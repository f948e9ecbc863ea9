// host_sim estimate on data whose answer is known by hand: m = 2 kg, k = 800 N/m, c = 1.5 N s/m, free decay.
#include <cmath>
#include <cstdio>
#include <random>

#include "tests/host_sim/program_test.hpp"

namespace {

const char* const kRig =
    "schema = \"rig/1\"\nname = \"oscillator\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\n"
    "stiffness_N_m = 800.0\nviscous_N_s_m = \"estimate\"\n";

// x = e^-dt cos(w t) with d = c / 2m, w = sqrt(k/m - d^2); late_s shifts the displacement.
std::string free_decay(int samples, double late_s = 0.0) {
  const double d = 1.5 / 4.0, w = std::sqrt(400.0 - d * d);
  const auto x = [&](double t) { return 0.01 * std::exp(-d * t) * std::cos(w * t); };
  const auto v = [&](double t) { return -0.01 * std::exp(-d * t) * (d * std::cos(w * t) + w * std::sin(w * t)); };
  std::string text = "t_s,displacement_1_m,velocity_1_m_s\n";
  for (int i = 0; i < samples; ++i) {
    char row[96];
    std::snprintf(row, sizeof row, "%.3f,%.12g,%.12g\n", i * 1e-3, x(i * 1e-3 - late_s), v(i * 1e-3));
    text += row;
  }
  return text;
}

class Estimate : public test_support::ProgramTest {
 protected:
  void SetUp() override {
    workspace_.write("rig.toml", kRig);
    workspace_.write("data.csv", free_decay(4000));
  }
};

TEST_F(Estimate, FindsTheDamperAndSaysHowWell) {
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto out = json("out.json");
  EXPECT_EQ(out["schema"], "estimate/1");
  EXPECT_NEAR(value(out, "viscous[1-0]"), 1.5, 1.5e-4);  // codes of 24 bits: far better than this
  EXPECT_EQ(out["parameters"][0]["status"], "VALID");
  EXPECT_EQ(out["parameters"][0]["unit"], "N s/m");
  EXPECT_EQ(out["samples"], 4000);
  EXPECT_NEAR(out["sample_rate_Hz"].get<double>(), 1000.0, 1e-6);
  EXPECT_LT(out["mse_percent"][0].get<double>(), 1e-3);  // its simulation runs as the rig did
}

// a = -(k x + c v) / m of the same decay, read by an accelerometer that stands in gravity: 0.45 g at rest.
TEST_F(Estimate, ComparesAnAccelerometerWithoutItsZero) {
  std::string with = "t_s,displacement_1_m,velocity_1_m_s,acceleration_1_m_s2\n", alone = "t_s,acceleration_1_m_s2\n";
  const double d = 1.5 / 4.0, w = std::sqrt(400.0 - d * d);
  for (int i = 0; i < 20000; ++i) {
    const double t = i * 1e-3, e = 0.01 * std::exp(-d * t), x = e * std::cos(w * t),
                 v = -e * (d * std::cos(w * t) + w * std::sin(w * t)), a = 4.41 - (800.0 * x + 1.5 * v) / 2.0;
    char row[120];
    std::snprintf(row, sizeof row, "%.3f,%.12g,%.12g,%.12g\n", t, x, v, a);
    with += row;
    std::snprintf(row, sizeof row, "%.3f,%.12g\n", t, a);
    alone += row;
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

// A logger that comes late at times, and pauses: samples at uneven times, and 40 that are missing.
TEST_F(Estimate, TakesUnevenTimesWhereAskedTo) {
  const double d = 1.5 / 4.0, w = std::sqrt(400.0 - d * d);
  std::mt19937 random(3);
  std::string text = "t_s,displacement_1_m,velocity_1_m_s\n";
  for (int i = 0; i < 4000; ++i) {
    const double late_s = random() % 100 == 0 ? 4e-4 : 0.0, t = i * 1e-3 + late_s, e = 0.01 * std::exp(-d * t);
    char row[96];
    std::snprintf(row, sizeof row, "%.4f,%.12g,%.12g\n", t, e * std::cos(w * t),
                  -e * (d * std::cos(w * t) + w * std::sin(w * t)));
    if (i < 2000 || i >= 2040) text += row;
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

TEST_F(Estimate, TableStandsOnStdoutAndNothingOnStderr) {
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv"});
  EXPECT_EQ(result.status, 0);
  for (const char* words :
       {"oscillator", "viscous[1-0]", "estimate", "95 %", "N s/m", "VALID", "4000 samples at 1000 Hz"})
    EXPECT_NE(result.output.find(words), std::string::npos) << words << " in\n" << result.output;
  EXPECT_EQ(result.errors, "");                              // no progress bar in a pipe
  EXPECT_EQ(result.output.find('\033'), std::string::npos);  // no colours either
  EXPECT_EQ(workspace_.entries(), (std::set<std::string>{"data.csv", "rig.toml"}));
}

TEST_F(Estimate, JsonOnStdoutIsAlone) {
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", "-"});
  EXPECT_EQ(nlohmann::json::parse(result.output)["schema"], "estimate/1");
  EXPECT_NE(result.errors.find("viscous[1-0]"), std::string::npos);
}

TEST_F(Estimate, FramesOfTheLogDecodeToTheSameEstimate) {
  const auto estimated = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--log", "-"});
  const auto decoded = host_sim({"decode"}, estimated.output);
  EXPECT_EQ(decoded.status, 0);
  EXPECT_NE(decoded.output.find("viscous[1-0]"), std::string::npos);
  EXPECT_NE(decoded.output.find("mode = DONE"), std::string::npos);
}

TEST_F(Estimate, SameInputSameBytes) {
  for (const char* name : {"a", "b"})
    host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", std::string(name) + ".json", "--log",
              std::string(name) + ".log"});
  EXPECT_EQ(workspace_.read("a.json"), workspace_.read("b.json"));
  EXPECT_EQ(workspace_.read("a.log"), workspace_.read("b.log"));
  EXPECT_GT(workspace_.read("a.log").size(), 1000u);
}

// With a log a whole board solves once a second, without one its core does at the end alone.
TEST_F(Estimate, TheLogChangesNothing) {
  workspace_.write("other.csv", free_decay(2600));
  std::vector<std::string> arguments = {"estimate", "--rig", "rig.toml", "--data", "data.csv", "other.csv", "--json"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), arguments.begin(), arguments.end());
    return host_sim(more);
  };
  ASSERT_EQ(with({"alone.json"}).status, 0);
  ASSERT_EQ(with({"logged.json", "--log", "out.log"}).status, 0);
  EXPECT_EQ(workspace_.read("alone.json"), workspace_.read("logged.json"));
}

TEST_F(Estimate, SeveralRecordsAreLevelsOfOneEstimate) {
  const auto result =
      host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--data", "data.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(json("out.json")["samples"], 8000);
  EXPECT_EQ(json("out.json")["levels"], 2);
}

// A displacement late by 400 us against the velocity adds k tau = 0.32 to the damper, until the rig file says so.
TEST_F(Estimate, SkewIsTakenAwayByTheChannelsDelay) {
  workspace_.write("late.csv", free_decay(4000, 400e-6));
  workspace_.write("told.toml", kRig + std::string("[[channel]]\nname = \"displacement_1_m\"\ndelay_us = 400.0\n"));
  const auto told = host_sim({"estimate", "--rig", "told.toml", "--data", "late.csv", "--json", "told.json"});
  ASSERT_EQ(told.status, 0) << told.errors;
  EXPECT_NEAR(value(json("told.json"), "viscous[1-0]"), 1.5, 0.015);
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
    char row[64];
    const double t = 2e-3 * i;
    std::snprintf(row, sizeof row, "%.3f,%.9g\n", t, 2.3 + std::exp(-d * t) * std::cos(w * t) + 0.003 * normal(random));
    text += row;
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
      char row[64];
      const double t = 0.034 * i;
      std::snprintf(row, sizeof row, "%.3f,%.9g\n", t, std::exp(-d * t) * std::cos(w * t) + 3.5e-4 * normal(random));
      text += row;
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

// An arm of 1.5 kg m^2 and 10.5 N m that a motor swings about straight up, 3 s to and fro: the angle is 3.14 at the mean, and gravity
// pulls to where it is zero, not to there. tau = 1.5 a + 10.5 sin(u) + 1 w + 1.2 sgn(w), u = 3.14 + 0.8 sin + 0.3 sin.
TEST_F(Estimate, GravityPullsToTheAnglesOwnZero) {
  workspace_.write("arm.toml",
                   "schema = \"rig/1\"\nname = \"arm\"\n[[dof]]\ninertia_kg_m2 = 1.5\n[[link]]\nbetween = [1, 0]\n"
                   "viscous_N_m_s_rad = \"estimate\"\ncoulomb_N_m = \"estimate\"\ngravity_torque_N_m = \"estimate\"\n");
  std::string text = "t_s,angle_1_rad,angular_velocity_1_rad_s,angular_acceleration_1_rad_s2,torque_1_N_m\n";
  const double w1 = 2.094395102393195, w2 = 5.3;
  for (int i = 0; i < 12000; ++i) {
    char row[128];
    const double t = 5e-3 * i, u = 3.14 + 0.8 * std::sin(w1 * t) + 0.3 * std::sin(w2 * t),
                 v = 0.8 * w1 * std::cos(w1 * t) + 0.3 * w2 * std::cos(w2 * t),
                 a = -0.8 * w1 * w1 * std::sin(w1 * t) - 0.3 * w2 * w2 * std::sin(w2 * t);
    std::snprintf(row, sizeof row, "%.3f,%.9g,%.9g,%.9g,%.9g\n", t, u, v, a,
                  1.5 * a + 10.5 * std::sin(u) + v + std::copysign(1.2, v));
    text += row;
  }
  workspace_.write("arm.csv", text);
  const auto result = host_sim({"estimate", "--rig", "arm.toml", "--data", "arm.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  const auto out = json("out.json");
  EXPECT_NEAR(value(out, "gravity_torque[1-0]"), 10.5, 0.2);
  EXPECT_NEAR(value(out, "viscous[1-0]"), 1.0, 0.05);
  EXPECT_EQ(result.output.find("position of rest"), std::string::npos) << result.output;
}

const char* const kPendulum =
    "schema = \"rig/1\"\nname = \"pendulum\"\n[[dof]]\ninertia_kg_m2 = 1.0\n[[link]]\nbetween = [1, 0]\n"
    "gravity_torque_N_m = \"estimate\"\nviscous_N_m_s_rad = \"estimate\"\n";

// A pendulum of G N m and c N m s/rad per unit inertia, let go at u rad, as rows of the time and what reading(u, w) says. 3000 steps a second or
// more.
template <typename Reading>
std::string swing_of(double G, double c, double u, double rate_Hz, int samples, const Reading& reading) {
  std::string text;
  double w = 0.0;
  const int steps = static_cast<int>(std::ceil(3000.0 / rate_Hz));
  const double h = 1 / (rate_Hz * steps);
  for (int i = 0; i < samples; ++i) {
    char row[64];
    std::snprintf(row, sizeof row, "%.4f,%.6f\n", i / rate_Hz, reading(u, w));
    text += row;
    for (int k = 0; k < steps; ++k) {
      u += 0.5 * h * w;
      w += h * (-G * std::sin(u) - c * w);
      u += 0.5 * h * w;
    }
  }
  return text;
}

// A pendulum of a video, G = 19.5 N m, c = 0.02, whose angle reads `zero_rad` where it hangs.
std::string video_of_a_pendulum(double zero_rad, uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return "t_s,angle_1_rad\n" +
         swing_of(19.5, 0.02, 0.3, 30, 3600, [&](double u, double) { return zero_rad + u + 0.0006 * normal(random); });
}

// A tenth of its swing. What it swings about is where it rests.
TEST_F(Estimate, ADecayIsCountedFromWhatItSwingsAbout) {
  workspace_.write("swing.toml", kPendulum);
  workspace_.write("swing.csv", video_of_a_pendulum(0.03, 4));
  const auto result = host_sim({"estimate", "--rig", "swing.toml", "--data", "swing.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_NEAR(value(json("out.json"), "gravity_torque[1-0]"), 19.5, 0.1);
  EXPECT_NE(result.output.find("swings about 0.0"), std::string::npos) << result.output;
}

// The string was hung up again between two records: counted from one place for both, -0.16, neither swung about its rest and all numbers
// were hidden by noise.
TEST_F(Estimate, DecaysThatRestApartAreCountedFromTheirOwn) {
  workspace_.write("swing.toml", kPendulum);
  workspace_.write("one.csv", video_of_a_pendulum(0.12, 5));
  workspace_.write("two.csv", video_of_a_pendulum(-0.44, 6));
  const auto result =
      host_sim({"estimate", "--rig", "swing.toml", "--data", "one.csv", "--data", "two.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_NEAR(value(json("out.json"), "gravity_torque[1-0]"), 19.5, 0.1);
  EXPECT_NE(result.output.find("swings about 0.12, -0.4"), std::string::npos) << result.output;
}

// A pendulum of G = 9.8 N m and c = 0.05 with a gyroscope, let go at `angle_rad`: 100 Hz, 60 s, 0.005 rad/s of noise.
std::string gyroscope_of_a_pendulum(double angle_rad) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  return "t_s,angular_velocity_1_rad_s\n" +
         swing_of(9.8, 0.05, angle_rad, 100, 6000, [&](double, double w) { return w + 0.005 * normal(random); });
}

// Behind the high-pass of an integrated angle sin(u) is another law: let go at 2.2 rad the torque came out as 8.2 +- 0.2 N m, VALID. At 0.3 rad
// it is the angle, and right.
TEST_F(Estimate, AGyroscopesWideSwingsAreNoMeasureOfGravity) {
  workspace_.write("swing.toml", kPendulum);
  workspace_.write("wide.csv", gyroscope_of_a_pendulum(2.2));
  workspace_.write("narrow.csv", gyroscope_of_a_pendulum(0.3));
  const auto wide = host_sim({"estimate", "--rig", "swing.toml", "--data", "wide.csv"});
  EXPECT_NE(wide.output.find("sin(u) is no longer its angle"), std::string::npos) << wide.output;
  EXPECT_EQ(wide.output.find(" VALID"), std::string::npos) << wide.output;
  const auto narrow = host_sim({"estimate", "--rig", "swing.toml", "--data", "narrow.csv", "--json", "out.json"});
  EXPECT_EQ(narrow.output.find("sin(u)"), std::string::npos) << narrow.output;
  EXPECT_NEAR(value(json("out.json"), "gravity_torque[1-0]"), 9.8, 0.05);
}

// Under whatever name: the recording, the rig file.
TEST_F(Estimate, NoResultTakesThePlaceOfAnInput) {
  const std::string data = workspace_.read("data.csv"), rig = workspace_.read("rig.toml");
  for (const std::string option : {"--json", "--log"})
    for (const std::string input : {"data.csv", "./data.csv", "rig.toml"}) {
      const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", option, input});
      EXPECT_NE(result.status, 0) << option << " " << input;
      EXPECT_NE(result.errors.find("is read by this command"), std::string::npos) << result.errors;
      EXPECT_EQ(workspace_.read("data.csv"), data);
      EXPECT_EQ(workspace_.read("rig.toml"), rig);
    }
  EXPECT_EQ(workspace_.entries(), (std::set<std::string>{"data.csv", "rig.toml"}));
}

TEST_F(Estimate, AFileGivenTwiceIsTold) {
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--data", "./data.csv"});
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.errors.find("./data.csv: is given twice"), std::string::npos) << result.errors;
}

TEST_F(Estimate, ASensitivityThatIsNotUsedIsTold) {
  const auto unused = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--unit", "displacement_1=m",
                                "--sensitivity", "displacement_1=100 mV/m"});
  EXPECT_EQ(unused.status, 0) << unused.errors;
  EXPECT_NE(unused.errors.find("its sensitivity of 100 mV/m is not used"), std::string::npos) << unused.errors;
  const auto nonsense =
      host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--sensitivity", "displacement_1=banana"});
  EXPECT_EQ(nonsense.status, 2);
  EXPECT_NE(nonsense.errors.find("\"banana\" is no sensitivity"), std::string::npos) << nonsense.errors;
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
  for (int i = 0; i < kSamples; ++i) {
    char row[96];
    std::snprintf(row, sizeof row, "%.9g,%.9g,%.9g\n", i / 80.0 / faster,
                  (force[static_cast<size_t>(i)] + noise(random)) * faster * faster,
                  (acceleration[static_cast<size_t>(i)] + noise(random)) * faster * faster);
    text += row;
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

TEST_F(Estimate, TooFewSamplesCannotAnswer) {
  workspace_.write("short.csv", free_decay(60));
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "short.csv", "--json", "out.json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.errors.find("record at least"), std::string::npos) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(workspace_.path() / "out.json"));
}

// Integrated accelerations settle first: no window closes within 1.2 s, four periods, and nothing is a number or tested.
TEST_F(Estimate, AccelerationsTooShortForAWindowCannotAnswer) {
  std::string text = "t_s,acceleration_1_m_s2\n";
  for (int i = 0; i < 1200; ++i) {
    char row[64];
    std::snprintf(row, sizeof row, "%.3f,%.12g\n", i * 1e-3, -4.0 * std::exp(-0.375e-3 * i) * std::cos(20e-3 * i));
    text += row;
  }
  workspace_.write("short.csv", text);
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "short.csv", "--json", "out.json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.errors.find("no window closed: a motion that is integrated"), std::string::npos) << result.errors;
  EXPECT_EQ(json("out.json")["parameters"][0]["status"], "STALE");
  EXPECT_TRUE(json("out.json")["mse_percent"][0].is_null());
}

// A decay of 0.2 s on an accelerometer of 200 steps, in a record of 8 s: the windows begin when it is over, and hold what the
// integration's high-pass makes of a start that nobody knows. A damper of its time constant (0.16 s) times k would do the same: 130 N s/m
// for 20.
TEST_F(Estimate, ADecayThatIsOverBeforeTheWindowsIsNoMotion) {
  constexpr double kMass_kg = 2.0, kStiffness_N_m = 800.0 * 16, kViscous_N_s_m = 20.0, kStep_m_s2 = 0.5;
  const double d = kViscous_N_s_m / (2 * kMass_kg), w = std::sqrt(kStiffness_N_m / kMass_kg - d * d);
  std::string text = "t_s,acceleration_1_m_s2\n";
  for (int i = 0; i < 4000; ++i) {
    const double t = i * 2e-3, e = 0.01 * std::exp(-d * t), x = e * std::cos(w * t),
                 v = -e * (d * std::cos(w * t) + w * std::sin(w * t));
    const double a = -(kStiffness_N_m * x + kViscous_N_s_m * v) / kMass_kg;
    char row[64];
    std::snprintf(row, sizeof row, "%.3f,%.6g\n", t, kStep_m_s2 * std::round(a / kStep_m_s2));
    text += row;
  }
  workspace_.write("blow.csv", text);
  workspace_.write("stiff.toml",
                   "schema = \"rig/1\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = 12800.0\n"
                   "viscous_N_s_m = \"estimate\"\n");
  const auto result = host_sim({"estimate", "--rig", "stiff.toml", "--data", "blow.csv", "--json", "out.json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.errors.find("integrated from rates"), std::string::npos) << result.errors;
  EXPECT_EQ(json("out.json")["parameters"][0]["status"], "ILL_CONDITIONED");
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
    char row[128];
    std::snprintf(row, sizeof row, "%.3f,%.9g,%.9g,%.9g\n", i * kStep_s, 2.0 * a + 400.0 * x + 3.0 * v, v, late_a);
    text += row;
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

TEST_F(Estimate, ARigThatDoesNotMoveCannotAnswer) {
  std::string text = "t_s,displacement_1_m,velocity_1_m_s\n";
  for (int i = 0; i < 2000; ++i) text += std::to_string(i * 1e-3) + ",0,0\n";
  workspace_.write("still.csv", text);
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "still.csv", "--json", "out.json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.errors.find("displacement_1_m: dead: never changes"), std::string::npos) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(workspace_.path() / "out.json"));
  const auto anyway =
      host_sim({"estimate", "--rig", "rig.toml", "--data", "still.csv", "--json", "out.json", "--anyway"});
  EXPECT_EQ(anyway.status, 3);
  EXPECT_NE(anyway.errors.find("viscous[1-0]"), std::string::npos) << anyway.errors;
  EXPECT_EQ(json("out.json")["parameters"][0]["status"], "NO_EXCITATION");
}

}  // namespace
