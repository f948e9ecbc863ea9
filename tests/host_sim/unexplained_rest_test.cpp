// What free runs leave that no effect explains, and the two ends of the valley between a damper and dry friction.
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "tests/host_sim/program_test.hpp"

namespace {

// 1.7 kg on 5200 N/m, a damper, dry friction that holds, and a further damping c(u) w; 10 us a step, every hundredth is recorded.
struct Rig {
  double viscous = 6.5, friction = 0.5;
  std::function<double(double)> further = [](double) { return 0.0; };
  std::function<double(double)> force_N;
  double start_m = 0.0;
};

std::string record(const Rig& rig, double duration_s, double noise_m, unsigned seed) {
  constexpr double kMass = 1.7, kStiffness = 5200.0, kStep = 1e-5;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::string text = "t_s,force_1_N,displacement_1_m\n";
  double x = rig.start_m, v = 0.0;
  const auto steps = static_cast<long>(std::lround(duration_s / kStep));
  for (long k = 0; k < steps; ++k) {
    const double t = kStep * static_cast<double>(k), f = rig.force_N(t);
    if (k % 100 == 0) {
      char row[96];
      std::snprintf(row, sizeof row, "%.3f,%.9g,%.9g\n", t, f, x + noise_m * normal(random));
      text += row;
    }
    const double pull = f - kStiffness * x;
    if (v == 0.0 && std::fabs(pull) <= rig.friction) continue;  // held
    const double way = v != 0.0 ? v : pull;
    const double a = (pull - (rig.viscous + rig.further(x)) * v - std::copysign(rig.friction, way)) / kMass;
    const double next = v + kStep * a;
    v = v * next < 0.0 ? 0.0 : next;  // it comes to a stop before it turns
    x += kStep * v;
  }
  return text;
}

class UnexplainedRest : public test_support::ProgramTest {
 protected:
  void SetUp() override {
    workspace_.write("rig.toml",
                     "schema = \"rig/1\"\nname = \"slide\"\n[[dof]]\nmass_kg = 1.7\n[[link]]\nbetween = [1, 0]\n"
                     "stiffness_N_m = 5200.0\nviscous_N_s_m = \"estimate\"\ncoulomb_N = \"estimate\"\n");
  }
  // Verdict and parameters of two records.
  nlohmann::json diagnosed(const std::string& one, const std::string& two) {
    workspace_.write("1.csv", one), workspace_.write("2.csv", two);
    const auto result = host_sim(
        {"diagnose", "--rig", "rig.toml", "--data", "1.csv", "--data", "2.csv", "--json", "out.json", "--anyway"});
    EXPECT_EQ(result.status, 0) << result.errors;
    sentence_ = result.output;
    return json("out.json");
  }
  std::string sentence_;
};

// 60 tones from 2 to 20 Hz of unlike phases, 7 N rms.
double tones(double t, double level, int phases) {
  double sum = 0.0;
  for (int k = 0; k < 60; ++k) sum += std::sin(2.0 * M_PI * (2.0 + 0.3 * k) * t + 1.3 * phases * k * k);
  return level * 7.0 * sum / std::sqrt(30.0);
}

Rig shaken(double level, int phases, double at_the_centre) {
  Rig rig;
  rig.force_N = [=](double t) { return tones(t, level, phases); };
  rig.further = [=](double u) { return at_the_centre * std::exp(-u * u / 1e-6); };  // a millimetre wide
  return rig;
}

TEST_F(UnexplainedRest, AForceOutsideTheVocabularyMakesNoNumberValid) {
  const auto out = diagnosed(record(shaken(0.6, 1, 12.0), 10.0, 1e-5, 1), record(shaken(1.2, 2, 12.0), 10.0, 1e-5, 2));
  for (const auto& p : out["baseline"]["parameters"]) {
    if (p["name"] == "coulomb[1-0]") {
      EXPECT_TRUE(p["status"] != "VALID" || p["value"].get<double>() < 0.55) << sentence_;
    }
  }
  EXPECT_EQ(sentence_.find("neither helps"), std::string::npos) << sentence_;
}

TEST_F(UnexplainedRest, ARightRigKeepsItsNumbers) {
  const auto out = diagnosed(record(shaken(0.6, 1, 0.0), 10.0, 1e-5, 1), record(shaken(1.2, 2, 0.0), 10.0, 1e-5, 2));
  EXPECT_EQ(out["verdict"], "none") << sentence_;
  for (const auto& p : out["baseline"]["parameters"]) {
    EXPECT_EQ(p["status"], "VALID") << p;
    EXPECT_NEAR(p["value"].get<double>(), p["name"] == "coulomb[1-0]" ? 0.5 : 6.5, 4.0 * p["std"].get<double>()) << p;
  }
}

// Held at 25 and 50 N, let go within 5 ms, over after two swings. The balance of forces gives nearly all to the damper, and its valley ends at
// 8.6 N s/m and 0.56 N, 16 % beside unseen data: whatever was fitted beside it from elsewhere was then named.
TEST_F(UnexplainedRest, AShortDecayIsFittedFromBothEndsOfItsValley) {
  const auto released = [](double held_N) {
    Rig rig;
    rig.friction = 1.2, rig.start_m = held_N / 5200.0;
    rig.force_N = [=](double t) { return held_N * std::clamp((0.505 - t) / 0.005, 0.0, 1.0); };
    return rig;
  };
  const auto out = diagnosed(record(released(25.0), 6.0, 1.5e-6, 3), record(released(50.0), 6.0, 1.5e-6, 4));
  EXPECT_EQ(out["verdict"], "none") << sentence_;
  for (const auto& p : out["baseline"]["parameters"])
    EXPECT_NEAR(p["value"].get<double>(), p["name"] == "coulomb[1-0]" ? 1.2 : 6.5, 0.1) << sentence_;
}

// 1 kg between springs of 10 N/m, of which the further end is moved, and 0.5 N s/m. The displacement is counted from where the near spring pulls with
// 16 N, ten times what it does on the rms: without that the rig file follows nothing.
TEST_F(UnexplainedRest, ADisplacementThatCountsFromFarOffIsAConstantForce) {
  workspace_.write(
      "rig.toml",
      "schema = \"rig/1\"\nname = \"between springs\"\n[[dof]]\nmass_kg = 1.0\n[[link]]\nbetween = [1, 0]\n"
      "stiffness_N_m = \"estimate\"\nviscous_N_s_m = \"estimate\"\n[[link]]\nbetween = [1, \"base\"]\n"
      "stiffness_N_m = \"estimate\"\n");
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::string text = "t_s,displacement_1_m,displacement_base_m\n";
  for (int i = 0; i < 2400; ++i) {
    const double t = 0.02 * i;
    double x = 0.0, v = 0.0, a = 0.0;
    for (int k = 0; k < 12; ++k) {
      const double w = 2.0 + 0.5 * k, phase = w * t + 0.7 * k * k;
      x += 0.06 * std::sin(phase), v += 0.06 * w * std::cos(phase), a -= 0.06 * w * w * std::sin(phase);
    }
    char row[96];
    std::snprintf(row, sizeof row, "%.2f,%.7g,%.7g\n", t, x + 2e-4 * normal(random),
                  (a + 0.5 * v + 20.0 * x - 16.0) / 10.0 + 2e-4 * normal(random));
    text += row;
  }
  workspace_.write("1.csv", text);
  const auto result = host_sim({"diagnose", "--rig", "rig.toml", "--data", "1.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto out = json("out.json");
  ASSERT_EQ(out["causes"].size(), 1u) << result.output;
  EXPECT_EQ(out["causes"][0]["effect"], "force_offset");
  for (const auto& p : out["extended"]["parameters"]) {
    if (p["name"] == "force_offset[1-0]") {
      EXPECT_NEAR(p["value"].get<double>(), -16.0, 0.3) << result.output;
    }
    if (p["name"] == "viscous[1-0]") {
      EXPECT_NEAR(p["value"].get<double>(), 0.5, 0.05) << result.output;
    }
  }
}

}  // namespace
