// The report of a real run: its numbers are those of the run, its pictures show the measured part.
#include "host_sim/reports/data/from_run.hpp"

#include <gtest/gtest.h>

#include "host_sim/reports/page/report.hpp"

namespace {

using namespace host_sim;

constexpr char kScenario[] = R"(schema = "scenario/1"
name = "one mass"
sample_rate_Hz = 1000.0
[[dof]]
mass_kg = 2.0
[[link]]
between = [1, 0]
stiffness_N_m = 800.0
viscous_N_s_m = "estimate"
coulomb_N = "estimate"
[truth]
"viscous[1-0]" = 4.0
"coulomb[1-0]" = 2.0
[[level]]
kind = "sine"
amplitude_N = 20.0
frequency_Hz = 4.0
settle_cycles = 4
cycles = 8
[[level]]
kind = "sine"
amplitude_N = 60.0
frequency_Hz = 4.0
settle_cycles = 4
cycles = 8
[sensors]
bits = 24
)";

TEST(FromRun, CarriesTheRunOver) {
  const Scenario scenario = parse_scenario(kScenario, "s.toml");
  ProgressSink none;
  reports::ConvergenceRecorder recorder(none);
  const RunResult result = run_scenario(scenario, 7, recorder);
  const reports::RunReportData data = reports::run_report_data(scenario, 7, result, recorder.convergence());

  ASSERT_EQ(data.parameters.size(), 2u);
  EXPECT_EQ(data.parameters[0].name, "viscous[1-0]");
  EXPECT_EQ(data.parameters[0].unit, "N s/m");
  EXPECT_EQ(data.parameters[0].truth, 4.0);
  EXPECT_EQ(data.parameters[0].estimate.value, result.parameters[0].value);
  const reports::Convergence& run = data.parameters[1].convergence;
  ASSERT_GE(run.value.size(), 3u);  // two ends of a level and the end of the run
  EXPECT_EQ(run.value.back(), result.parameters[1].value);

  ASSERT_EQ(data.records.size(), 2u);
  EXPECT_EQ(data.records[1].label, "Level 2: sine of 60 N at 4 Hz");
  ASSERT_EQ(data.records[0].channels.size(), 2u);  // force and displacement: velocity and acceleration say no more
  EXPECT_EQ(data.records[0].channels[0].name, "force of DOF 1");
  EXPECT_EQ(data.records[0].channels[0].clean.size(), 2001u);  // 8 cycles of 250 samples, both ends
  ASSERT_EQ(data.records[0].accelerations.size(), 1u);
  EXPECT_EQ(data.records[0].accelerations[0].simulated.size(), 2001u);
  EXPECT_NE(reports::run_page(data).find("Run of one mass"), std::string::npos);
}

}  // namespace
