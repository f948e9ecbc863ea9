// host_sim diagnose end to end: a hardening spring that the rig file does not know. What is found in which noise is the
// business of tests/diagnosis; here it is what a user gets.
#include <cmath>
#include <cstdio>
#include <random>

#include "tests/host_sim/program_test.hpp"

namespace {

const char* const kRig =
    "schema = \"rig/1\"\nname = \"oscillator\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\n"
    "stiffness_N_m = 800.0\nviscous_N_s_m = \"estimate\"\n";

// A motion of five sines, and the force that it needs: f = 2 a + 800 x + 6 v + cubic x^3; 0.1 % of noise on each.
std::string record(double cubic) {
  constexpr double kHz[] = {3.1, 5.3, 7.7, 11.9, 17.3}, kAmplitude_m[] = {6e-3, 4e-3, 3e-3, 1.5e-3, 1e-3};
  std::mt19937 random(7);
  const auto noise = [&](double rms) {
    return rms * std::sqrt(3.0) * (static_cast<double>(random()) / 2147483648.0 - 1.0);
  };
  std::string text = "t_s,force_1_N,displacement_1_m,velocity_1_m_s,acceleration_1_m_s2\n";
  for (int i = 0; i < 20000; ++i) {
    double x = 0.0, v = 0.0, a = 0.0;
    for (int k = 0; k < 5; ++k) {
      const double w = 2.0 * M_PI * kHz[k], phase = w * i * 1e-3 + k * k;
      x += kAmplitude_m[k] * std::sin(phase);
      v += kAmplitude_m[k] * w * std::cos(phase);
      a -= kAmplitude_m[k] * w * w * std::sin(phase);
    }
    const double force = 2.0 * a + 800.0 * x + 6.0 * v + cubic * x * x * x;
    char row[160];
    std::snprintf(row, sizeof row, "%.3f,%.9g,%.9g,%.9g,%.9g\n", i * 1e-3, force + noise(0.02), x + noise(6e-6),
                  v + noise(2.5e-4), a + noise(0.015));
    text += row;
  }
  return text;
}

class Diagnose : public test_support::ProgramTest {
 protected:
  void SetUp() override {
    workspace_.write("rig.toml", kRig);
    workspace_.write("hidden.csv", record(4.0e6));
  }
};

TEST_F(Diagnose, NamesTheHiddenSpringAndWritesAllThatWasAskedFor) {
  const auto result = host_sim({"diagnose", "--rig", "rig.toml", "--data", "hidden.csv", "--json", "out.json",
                                "--report", "report", "--extended-rig", "extended.toml"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto out = json("out.json");
  EXPECT_EQ(out["schema"], "diagnosis/1");
  EXPECT_EQ(out["verdict"], "explained") << out.dump(1);
  ASSERT_EQ(out["causes"].size(), 1u) << out.dump(1);
  EXPECT_EQ(out["causes"][0]["effect"], "cubic_stiffness");
  EXPECT_EQ(out["causes"][0]["where"], "link 1-0");
  EXPECT_NE(result.output.find("cubic stiffness on link 1-0"), std::string::npos) << result.output;
  EXPECT_EQ(result.errors, "");  // no progress bar in a pipe
  const std::string page = workspace_.read("report/index.html");
  EXPECT_NE(page.find("cubic stiffness on link 1-0"), std::string::npos);
  EXPECT_NE(page.find("<h2 id=\"links\">"), std::string::npos);
  for (const char* fetched : {"src=\"http", "href=\"http", "url(http", "src=\"//", "import("})
    EXPECT_EQ(page.find(fetched), std::string::npos) << fetched;
  std::set<std::string> entries = workspace_.entries();
  for (auto entry = entries.begin(); entry != entries.end();)
    entry = entry->find("report/figures/") == 0 ? entries.erase(entry) : std::next(entry);
  EXPECT_EQ(entries,
            (std::set<std::string>{"extended.toml", "hidden.csv", "out.json", "report/index.html", "rig.toml"}));
}

TEST_F(Diagnose, TheExtendedRigIsEstimatedByTheCore) {
  ASSERT_EQ(
      host_sim({"diagnose", "--rig", "rig.toml", "--data", "hidden.csv", "--extended-rig", "extended.toml"}).status, 0);
  const auto result = host_sim({"estimate", "--rig", "extended.toml", "--data", "hidden.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NEAR(value(json("out.json"), "cubic_stiffness[1-0]"), 4.0e6, 4.0e5);
}

// Beside the spring that was found nothing is left: what would have been seen is listed, as coefficients and as shares of force.
TEST_F(Diagnose, NothingIsLeftBesideTheExtendedRig) {
  ASSERT_EQ(
      host_sim({"diagnose", "--rig", "rig.toml", "--data", "hidden.csv", "--extended-rig", "extended.toml"}).status, 0);
  const auto result = host_sim({"diagnose", "--rig", "extended.toml", "--data", "hidden.csv", "--report", "report",
                                "--extended-rig", "again.toml"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("\nnone: "), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("extended rig: again.toml (the rig as given: nothing was named that could be added)\n"),
            std::string::npos)
      << result.output;
  EXPECT_NE(result.output.find("would have been seen from"), std::string::npos) << result.output;
  std::istringstream lines(result.output);
  int shares = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.find(" on link 1-0  ") != std::string::npos) {
      EXPECT_EQ(line.substr(line.size() - 2), " %") << line;
      ++shares;
    }
  EXPECT_GE(shares, 8) << result.output;
  const std::string page = workspace_.read("report/index.html");
  EXPECT_NE(page.find("What would have been seen"), std::string::npos);
}

// What would have been seen is told beside what is named: beside the rig as given the spring's own force hid all others. So it is what the
// rig file that has the spring is told.
TEST_F(Diagnose, WhatWouldHaveBeenSeenIsBesideWhatIsNamed) {
  ASSERT_EQ(host_sim({"diagnose", "--rig", "rig.toml", "--data", "hidden.csv", "--json", "named.json", "--extended-rig",
                      "extended.toml"})
                .status,
            0);
  ASSERT_EQ(host_sim({"diagnose", "--rig", "extended.toml", "--data", "hidden.csv", "--json", "none.json"}).status, 0);
  const auto named = json("named.json"), none = json("none.json");
  ASSERT_EQ(named["verdict"], "explained");
  ASSERT_EQ(none["verdict"], "none");
  size_t compared = 0;
  for (const auto& limit : none["minimum_detectable"])
    for (const auto& other : named["minimum_detectable"]) {
      if (limit["effect"] != other["effect"] || limit["where"] != other["where"]) continue;
      if (!limit["strength"].is_number() || !other["strength"].is_number()) continue;
      EXPECT_NEAR(other["strength"].get<double>() / limit["strength"].get<double>(), 1.0, 0.05) << limit["effect"];
      ++compared;
    }
  EXPECT_GE(compared, 8u);
}

TEST_F(Diagnose, AFailedRunLeavesNothing) {
  const auto result = host_sim({"diagnose", "--rig", "rig.toml", "--data", "missing.csv", "--json", "out.json",
                                "--report", "report", "--extended-rig", "extended.toml"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("missing.csv"), std::string::npos) << result.errors;
  EXPECT_EQ(workspace_.entries(), (std::set<std::string>{"hidden.csv", "rig.toml"}));
}

// A drawer at a constant 0.5 m/s under 3 N: of damper and friction only the sum 0.5 c + F is known.
TEST_F(Diagnose, RecordsThatDetermineNothingEndWithStatus3) {
  std::mt19937 random(1);
  const auto noise = [&](double rms) { return rms * (static_cast<double>(random()) / 2147483648.0 - 1.0); };
  std::string text = "t_s,force_1_N,displacement_1_m,velocity_1_m_s\n";
  for (int i = 0; i < 4000; ++i) {
    char row[120];
    std::snprintf(row, sizeof row, "%.3f,%.9g,%.9g,%.9g\n", i * 1e-3, 3 + noise(0.02), 5e-4 * i + noise(1e-5),
                  0.5 + noise(3e-3));
    text += row;
  }
  workspace_.write("drawer.csv", text);
  workspace_.write("drawer.toml",
                   "schema = \"rig/1\"\nname = \"drawer\"\n[[dof]]\nmass_kg = 1.0\n[[link]]\nbetween = [1, 0]\n"
                   "viscous_N_s_m = \"estimate\"\ncoulomb_N = \"estimate\"\n");
  const auto result = host_sim({"diagnose", "--rig", "drawer.toml", "--data", "drawer.csv", "--json", "out.json"});
  EXPECT_EQ(result.status, 3) << result.output;
  EXPECT_NE(result.errors.find("determine no coefficient"), std::string::npos) << result.errors;
  for (const auto& parameter : json("out.json")["extended"]["parameters"])
    EXPECT_EQ(parameter["status"], "ILL_CONDITIONED") << parameter.dump();
  // nor is it said that nothing is missing, or from which strength on it would have been seen
  EXPECT_EQ(json("out.json")["verdict"], "unknown");
  EXPECT_TRUE(json("out.json")["determines_nothing"]);
  EXPECT_TRUE(json("out.json")["minimum_detectable"].empty());
  EXPECT_EQ(result.output.find("would have been seen"), std::string::npos) << result.output;
}

TEST_F(Diagnose, WhatTheFitHasSeenIsNoHoldout) {
  const auto result = host_sim({"diagnose", "--rig", "rig.toml", "--data", "hidden.csv", "--holdout", "./hidden.csv"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("is given to --data and to --holdout"), std::string::npos) << result.errors;
}

TEST_F(Diagnose, HoldoutRecordsMustHaveTheSameChannels) {
  workspace_.write("other.csv", "t_s,displacement_1_m\n0,1\n0.001,2\n0.002,3\n");
  const auto result = host_sim({"diagnose", "--rig", "rig.toml", "--data", "hidden.csv", "--holdout", "other.csv"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("other.csv"), std::string::npos) << result.errors;
}

}  // namespace
