// A diagnosis, made by hand, as report data.
#include "host_sim/reports/data/from_diagnosis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/plant/motion/simulate.hpp"
#include "host_sim/reports/page/report.hpp"

namespace {

using namespace host_sim;

rig_file::RigModel rig(const std::string& more) {
  return rig_file::parse_rig(
      "schema = \"rig/1\"\nname = \"one mass\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\n"
      "stiffness_N_m = 800.0\n" +
          more,
      "rig.toml");
}

// The true rig has c = 4 and k3 = 5e5; the fit of the rig as given ended at c = 6.
struct Case {
  rig_file::RigModel given = rig("viscous_N_s_m = \"estimate\"\n");
  std::vector<Record> records;
  diagnosis::Diagnosis found;

  Case() {
    InitialState initial;
    initial.x_m = {0.03};
    const auto truth = rig("viscous_N_s_m = 4.0\n[[link.effect]]\nkind = \"cubic_stiffness\"\ncoefficient = 5.0e5\n");
    records.push_back(simulate(truth, initial, Excitation{}, SampleTimes{1e-3, 0, 0, 4000, 0.0}));
    records[0].file = "some/where/decay.csv";
    found.verdict = diagnosis::Verdict::kExplained;
    found.baseline.parameters = {{"viscous[1-0]", 6.0, "N s/m", 0.5, true}};
    found.extended.parameters = {{"viscous[1-0]", 4.0, "N s/m", 0.1, true},
                                 {"cubic_stiffness[1-0]", 5.0e5, "N/m^3", 1e3, true}};
    found.causes = {{"cubic_stiffness", "link 1-0", {found.extended.parameters[1]}, 99.0, 1234.0}};
    found.ranked = {{"end_stop", "link 1-0", 2000.0, 35.0},
                    {"cubic_stiffness", "link 1-0", 1234.0, 35.0},
                    {"mass_error", "dof 1", 12.0, 35.0}};
    found.rejected = {{"end_stop", "link 1-0", {}, 80.0, 2000.0}};
    found.baseline.holdout_nrmse_percent = {30.0};
    found.baseline.holdout_mse_percent = {9.0};
    found.extended.holdout_nrmse_percent = {1.5};
    found.extended.holdout_mse_percent = {0.1};
    found.extended_rig =
        rig("viscous_N_s_m = \"estimate\"\n[[link.effect]]\nkind = \"cubic_stiffness\"\ncoefficient = \"estimate\"\n");
    found.minimum_detectable = {{"mass_error", "dof 1", 0.002, "kg", 0.4}};
    found.advice = {"raise the level"};
  }
};

reports::DiagnosisReportData data_of(const Case& c, const std::vector<Record>& holdout) {
  reports::DiagnosisReportData data = reports::findings_of(c.given, c.records, holdout, c.found);
  reports::add_pictures(c.given, c.records, holdout, c.found, data);
  return data;
}

TEST(FromDiagnosis, CarriesTheFindingsOver) {
  const Case c;
  const reports::DiagnosisReportData data = data_of(c, {});
  EXPECT_EQ(data.rig_name, "one mass");
  EXPECT_EQ(data.files, std::vector<std::string>{"decay.csv"});
  EXPECT_EQ(data.verdict, "explained");
  ASSERT_EQ(data.parameters.size(), 2u);
  EXPECT_EQ(data.parameters[0].before.value, 6.0);
  EXPECT_NEAR(data.parameters[0].after.low, 4.0 - 0.196, 1e-12);
  EXPECT_TRUE(std::isnan(data.parameters[1].before.value));
  EXPECT_EQ(data.parameters[1].after.value, 5.0e5);
  EXPECT_EQ(data.parameters[0].status, "VALID");
  ASSERT_EQ(data.minimum_detectable.size(), 1u);
  EXPECT_EQ(data.minimum_detectable[0].percent_of_damping_force, 0.4);
  ASSERT_EQ(data.gains.size(), 1u);
  EXPECT_EQ(data.gains[0].nrmse_after_percent, 1.5);
  ASSERT_EQ(data.candidates.size(), 3u);
  EXPECT_EQ(data.candidates[0].effect, "end_stop");  // ranked first, and yet refused
  EXPECT_FALSE(data.candidates[0].chosen);
  EXPECT_EQ(data.candidates[0].remark, "fits better, but simulates the held-out data worse");
  EXPECT_TRUE(data.candidates[1].chosen);
  EXPECT_EQ(data.candidates[2].remark, "not more than noise would bring");
  EXPECT_EQ(data.candidates[2].threshold, 35.0);
  EXPECT_NE(reports::diagnosis_page(data).find("unseen data is 20 times smaller"), std::string::npos);
}

// 1.74e8 +- 8e11 is no number.
TEST(FromDiagnosis, ShowsNoNumberWhoseMagnitudeIsNotKnown) {
  Case c;
  c.found.baseline.parameters[0].undetermined = true, c.found.baseline.parameters[0].std = 59;  // of 6
  EXPECT_EQ(data_of(c, {}).parameters[0].before.value, 6.0);
  c.found.baseline.parameters[0].std = 61;
  EXPECT_TRUE(std::isnan(data_of(c, {}).parameters[0].before.value));
  c.found.baseline.parameters[0].undetermined = false;  // a friction that is nought, as well as it can be told
  EXPECT_EQ(data_of(c, {}).parameters[0].before.value, 6.0);
}

// The pictures are made with the parameters found: the extended rig follows the record, the given one does not.
TEST(FromDiagnosis, PicturesUseTheParametersFound) {
  const Case c;
  const reports::DiagnosisReportData data = data_of(c, {});
  const reports::Waveform& x = data.dofs.at(0).waveforms.at(0);
  double error = 0.0, error_given = 0.0;
  for (size_t i = 0; i < x.measured.size(); ++i) {
    error = std::max(error, std::abs(x.extended[i] - x.measured[i]));
    error_given = std::max(error_given, std::abs(x.simulated[i] - x.measured[i]));
  }
  EXPECT_LT(error, 3e-7);
  EXPECT_GT(error_given, 3e-3);
}

TEST(FromDiagnosis, AHoldoutRecordIsShownWhole) {
  const Case c;
  const reports::DiagnosisReportData data = data_of(c, c.records);
  EXPECT_EQ(data.facts.at(3), "pictures: decay.csv, which the fit has not seen");
  EXPECT_EQ(data.facts.at(0), "held out: decay.csv");
}

// A cubic spring is at work where the motion is large: the record where it is not would show nothing.
TEST(FromDiagnosis, PicturesShowTheRecordThatTheRigAsGivenMissesMost) {
  Case c;
  InitialState small;
  small.x_m = {0.0003};
  Record quiet = simulate(rig("viscous_N_s_m = 6.0\n"), small, Excitation{}, SampleTimes{1e-3, 0, 0, 4000, 0.0});
  quiet.file = "some/where/quiet.csv";
  c.records.insert(c.records.begin(), quiet);
  const reports::DiagnosisReportData seen = data_of(c, {});
  EXPECT_EQ(seen.facts.at(2), "pictures: decay.csv, which the fit has seen and the rig as given misses most");
  EXPECT_EQ(seen.dofs.at(0).waveforms.at(0).measured, c.records[1].find(Quantity::kDisplacement, 1)->values);
  EXPECT_EQ(seen.facts.at(0), "2 records of 4 s each at 1000 Hz");
  EXPECT_EQ(data_of(c, c.records).facts.at(4),
            "pictures: decay.csv, which the fit has not seen and the rig as given misses most");
}

}  // namespace
