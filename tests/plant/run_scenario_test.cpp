// Whole runs: shaker, rig, sensors and the fixed-point core, judged against the known truth.
#include "host_sim/virtual_rig/run_scenario.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/plant/scenario_texts.hpp"

namespace {

host_sim::RunResult run(const host_sim::Scenario& scenario, uint64_t seed = 1) {
  host_sim::ProgressSink quiet;
  return host_sim::run_scenario(scenario, seed, quiet);
}

double worst_error_percent(const host_sim::RunResult& result) {
  double worst = 0.0;
  for (const auto& parameter : result.parameters)
    worst = std::max(worst, 100.0 * std::fabs(parameter.value / parameter.truth - 1.0));
  return worst;
}

// The limits that the project sets itself for clean 24-bit data; the paper's own figures are ten to fifty times these.
TEST(RunScenario, CleanPaperScenariosFindTheTruth) {
  const std::pair<const char*, double> limits[] = {{"paper_1dof", 0.1},
                                                   {"paper_2dof", 0.1},
                                                   {"paper_3dof_two_frequencies", 0.1},
                                                   {"paper_3dof_random", 0.02},
                                                   {"paper_3dof_free_decay", 0.2}};
  for (const auto& limit : limits) {
    const auto result = run(host_sim::load_scenario(limit.first));
    EXPECT_LT(worst_error_percent(result), limit.second) << limit.first;
    EXPECT_EQ(result.health.missed_samples, 0u);
    EXPECT_EQ(result.health.saturated_samples, 0u);
    for (double mse : result.mse_percent) EXPECT_LT(mse, 1e-5) << limit.first;
  }
}

TEST(RunScenario, OneFrequencyIsNotCalledValidUnlessItIsRight) {
  for (const auto& parameter : run(host_sim::load_scenario("paper_3dof_one_frequency")).parameters)
    if (parameter.status == firmware::EstimateStatus::kValid) {
      EXPECT_NEAR(parameter.value / parameter.truth, 1.0, 0.1) << parameter.info.name;
    }
}

// Eq. 14 with the base really moving: W0 cos through the spring k to "base" in place of the force k W0 cos.
TEST(RunScenario, MovingBaseGivesTheSameEstimatesAsItsForce) {
  std::string text = host_sim::shipped_scenario_text("paper_2dof");
  const auto replace = [&text](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  replace("between = [1, 0]", "between = [1, \"base\"]");
  const char* force[] = {"amplitude_N = 400.0", "amplitude_N = 800.0", "amplitude_N = 1800.0"};
  const char* motion[] = {"amplitude_m = 40.0", "amplitude_m = 80.0", "amplitude_m = 180.0"};
  for (int i = 0; i < 3; ++i) {
    replace("kind = \"sine\"", "kind = \"base_sine\"");
    replace(force[i], motion[i]);
  }
  const auto by_base = run(host_sim::parse_scenario(text, "base.toml")),
             by_force = run(host_sim::load_scenario("paper_2dof"));
  ASSERT_EQ(by_base.parameters.size(), by_force.parameters.size());
  for (size_t i = 0; i < by_base.parameters.size(); ++i)
    EXPECT_NEAR(by_base.parameters[i].value / by_force.parameters[i].value, 1.0, 1e-4)
        << by_base.parameters[i].info.name;
  EXPECT_LT(worst_error_percent(by_base), 0.1);
}

TEST(RunScenario, ProgressIsToldInOrder) {
  struct Sink : host_sim::ProgressSink {
    double share = 0.0;
    uint64_t last_frame = 0;
    int heartbeats = 0, windows = 0, lasts = 0, begins = 0;
    void begin(const host_sim::Scenario&, const firmware::CoreConfiguration& c) override { begins += c.dof_count; }
    void progress(double value) override {
      EXPECT_GE(value, share);
      share = value;
    }
    void frame(const hal::CanFrame& frame) override {
      EXPECT_GE(frame.time_ns, last_frame);
      last_frame = frame.time_ns;
      heartbeats += frame.id == 0x701 ? 1 : 0;
    }
    void window(uint64_t, const firmware::Estimates& e, const firmware::CoreHealth&, bool last) override {
      EXPECT_EQ(e.unknown_count, 1);
      windows += last ? 0 : 1;
      lasts += last ? 1 : 0;
    }
  } sink;
  host_sim::run_scenario(host_sim::parse_scenario(plant_test::small_scenario(), "small.toml"), 1, sink);
  EXPECT_EQ(sink.begins, 1);
  EXPECT_EQ(sink.share, 1.0);
  EXPECT_EQ(sink.heartbeats, 33);  // boot-up at 0, each 100 ms of 3.128 s, one when all is done
  EXPECT_EQ(sink.windows, 3);      // after 1000 and 2000 samples, and at the level's end
  EXPECT_EQ(sink.lasts, 1);
}

TEST(RunScenario, SameSeedSameEstimatesBitByBit) {
  const auto scenario = host_sim::load_scenario("paper_2dof_noise");
  const auto a = run(scenario, 4), b = run(scenario, 4), c = run(scenario, 5);
  for (size_t i = 0; i < a.parameters.size(); ++i) {
    EXPECT_EQ(a.parameters[i].value, b.parameters[i].value);
    EXPECT_NE(a.parameters[i].value, c.parameters[i].value);
  }
  EXPECT_EQ(a.mse_percent, b.mse_percent);
}

// A rig file that leaves Coulomb friction out estimates a viscous term that stands in for it; Eq. 13 tells: the plant
// is simulated with the friction, the estimate without.
TEST(RunScenario, MeanSquareErrorShowsAMissingTerm) {
  host_sim::Scenario scenario = host_sim::parse_scenario(plant_test::small_scenario(), "small.toml");
  const double complete = run(scenario).mse_percent[0];
  scenario.plant.links[0].coulomb_N.value = 4.0;
  const double lacking = run(scenario).mse_percent[0];
  EXPECT_LT(complete, 1e-6);
  EXPECT_GT(lacking, 1e-2);
}

// Sensor sets as real rigs have them, at 0.1 % noise: every c within 2 %.
TEST(RunScenario, OneMotionQuantityIsEnough) {
  for (const char* quantity : {"displacement", "velocity", "acceleration"}) {
    std::string text = host_sim::shipped_scenario_text("paper_3dof_random");
    text.replace(text.find("bits = 24"), 9,
                 std::string("noise_percent = 0.1\nchannels = [\"force\", \"") + quantity + "\"]");
    for (const auto& parameter : run(host_sim::parse_scenario(text, "one.toml")).parameters)
      if (parameter.info.kind == firmware::TermKind::kViscous) {
        EXPECT_NEAR(parameter.value / parameter.truth, 1.0, 0.02) << quantity << " " << parameter.info.name;
      }
  }
}

// 4 Hz at 1 kHz: 250 samples; 5 and 10 Hz: 200 is the common cycle; 3 Hz does not fit into whole samples.
TEST(RunScenario, WindowsAreWholeCyclesWhereTheyCanBe) {
  const auto window = [](const std::string& name) { return host_sim::scenario_window(host_sim::load_scenario(name)); };
  EXPECT_EQ(window("paper_2dof").mode, firmware::WindowMode::kWholeCycles);
  EXPECT_EQ(window("paper_2dof").cycle_samples_numerator, 250u);
  EXPECT_EQ(window("paper_3dof_two_frequencies").cycle_samples_numerator, 200u);
  EXPECT_EQ(window("paper_3dof_random").mode, firmware::WindowMode::kInterval);
  EXPECT_EQ(window("paper_3dof_free_decay").mode, firmware::WindowMode::kFreeDecay);
  const std::string odd = plant_test::spoiled("frequency_Hz = 4.0", "frequency_Hz = 3.0");
  EXPECT_EQ(host_sim::scenario_window(host_sim::parse_scenario(odd, "odd.toml")).mode, firmware::WindowMode::kInterval);
}

}  // namespace
