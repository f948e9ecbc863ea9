// The marks of the accuracy report on fewer draws with fixed seeds. Limits are two-sided: an estimator that shrinks its
// scatter by leaning on the truth, or quotes too wide intervals, fails as well as a worse one.
//
// 30 draws: a bias estimate scatters by std / 5.5, an rms ratio by 13 %. Limits are some four such scatters wide.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/accuracy/redraw.hpp"
#include "tests/accuracy/special_cases.hpp"
#include "tests/accuracy/statistics.hpp"

namespace {

constexpr int kDraws = 30;

accuracy::Case find_case(const std::string& name) {
  for (const accuracy::Case& c : accuracy::noisy_cases())
    if (c.name == name) return c;
  ADD_FAILURE() << "no case " << name;
  return {};
}

void expect_marks(const std::string& name) {
  const accuracy::CaseStatistics statistics = accuracy::measure_case(find_case(name).scenario, 500, kDraws);
  double coverage = 0.0;
  for (const accuracy::ParameterStatistics& p : statistics.parameters) {
    SCOPED_TRACE(name + " " + p.name);
    EXPECT_LT(std::fabs(p.bias_percent), 0.2 + (0.2 + 4.0 / std::sqrt(kDraws)) * p.deviation_percent);
    EXPECT_LT(p.rms_percent, 1.1 * 1.5 * p.bound_rows_percent);
    EXPECT_GT(p.rms_percent, 0.6 * p.bound_identities_percent);
    EXPECT_LT(p.quoted_percent, 1.7 * p.deviation_percent);
    EXPECT_GT(p.quoted_percent, 0.6 * p.deviation_percent);
    // four fifths of right numbers are VALID: some records do not exclude a damping law that would make them wrong
    EXPECT_LE(p.not_valid, kDraws / 5);
    coverage += p.coverage_percent / static_cast<double>(statistics.parameters.size());
  }
  EXPECT_GT(coverage, 86.0) << name;
}

}  // namespace

TEST(Accuracy, CleanScenariosMeetTheirMarks) {
  for (const accuracy::CleanCase& c : accuracy::clean_cases()) {
    const double error = accuracy::clean_error_percent(c.scenario);
    EXPECT_LE(error, c.limit_percent) << c.name;
    EXPECT_GT(error, 1e-7) << c.name << ": better than 24 bits can be";
  }
}

TEST(Accuracy, TwoDofOneCycle) { expect_marks("paper_2dof_noise"); }
TEST(Accuracy, TwoFrequencies) { expect_marks("paper_3dof_two_frequencies_noise"); }
TEST(Accuracy, FreeDecay) { expect_marks("paper_3dof_free_decay"); }

// The plain product is biased by noise where the instrument is not: friction of the 3-DOF rig reads low.
TEST(Accuracy, PlainProductIsBiasedInstrumentIsNot) {
  const accuracy::CaseStatistics statistics =
      accuracy::measure_case(find_case("paper_3dof_two_frequencies_noise").scenario, 900, kDraws);
  const accuracy::ParameterStatistics& viscous = statistics.parameters[0];
  EXPECT_LT(viscous.plain_bias_percent, -0.4);
  EXPECT_GT(viscous.plain_bias_percent, -1.2);
  EXPECT_LT(std::fabs(viscous.bias_percent), 0.3);
}

TEST(Accuracy, OneFrequencyIsIllConditionedUntilTheAdviceIsFollowed) {
  const accuracy::FollowedAdvice advice = accuracy::follow_advice(10);
  EXPECT_GE(advice.ill_conditioned_clean, 4);
  EXPECT_EQ(advice.ill_conditioned_noisy, 10);
  EXPECT_GT(advice.advised_Hz, 12.0);
  EXPECT_LT(advice.advised_Hz, 25.0);
  EXPECT_EQ(advice.valid_after, 5);
  EXPECT_LT(advice.error_after_percent, 1.0);
}

TEST(Accuracy, LateDisplacementIsMeasuredAndCompensated) {
  const accuracy::SkewMeasurement skew = accuracy::measure_skew(10);
  for (size_t i = 0; i < 3; ++i) {
    SCOPED_TRACE("DOF " + std::to_string(i + 1));
    EXPECT_NEAR(skew.mean_us[i], 250.0, 15.0);
    EXPECT_LT(skew.deviation_us[i], 2.0 * skew.bound_us[i]);  // 10 draws: a deviation scatters by a quarter
    EXPECT_GT(skew.deviation_us[i], 0.3 * skew.bound_us[i]);
  }
  EXPECT_EQ(skew.marked_percent, 100.0);
  for (size_t k = 0; k < 4; ++k) {
    EXPECT_GT(skew.error_before_percent[k], 8.0);
    EXPECT_LT(std::fabs(skew.error_after_percent[k]), 1.0);
  }
}

// Mass 2 and stiffness 1-2 unknown as well, 5 % noise: the displacement-weighted rows see them. With the displacement
// itself as the weight its noise would meet itself in the spring force: mass 1.4 % and stiffness 1.6 % off.
TEST(Accuracy, UnknownMassAndStiffnessAreSeenByDisplacementRows) {
  std::string text = host_sim::shipped_scenario_text("paper_3dof_random");
  const auto replace = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  replace("mass_kg = 1.3", "mass_kg = \"estimate\"");
  replace("between = [1, 2]\nstiffness_N_m = 1.0e4", "between = [1, 2]\nstiffness_N_m = \"estimate\"");
  replace("[truth]\n", "[truth]\n\"mass[2]\" = 1.3\n\"stiffness[1-2]\" = 1.0e4\n");
  host_sim::Scenario scenario = host_sim::parse_scenario(text, "mass and stiffness unknown");
  scenario.sensors.every.noise_percent = 5.0;
  accuracy::Redraw redraw(scenario);
  std::vector<double> mean(scenario.truth.size(), 0.0);
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const firmware::Estimates& estimates = redraw.run(seed);
    for (size_t k = 0; k < mean.size(); ++k)
      mean[k] += 10.0 * (rig_file::to_double(estimates.parameters[k].value) / scenario.truth[k] - 1.0);
  }
  EXPECT_LT(std::fabs(mean[0]), 0.3);  // mass[2]; ten draws scatter by 0.06
  EXPECT_LT(std::fabs(mean[2]), 0.5);  // stiffness[1-2]; by 0.07
}

TEST(Accuracy, DisplacementAloneGivesViscousWithinTwoPercent) {
  for (const accuracy::SensorSet& set : accuracy::measure_sensor_sets(3)) {
    if (set.name != "displacement") continue;
    EXPECT_LT(set.worst_viscous_percent, 2.0);
    EXPECT_GT(set.worst_viscous_percent, 1e-4);
  }
}
