// Recordings of real rigs: what is named, and what it gains on data that the fit has not seen. The recordings are not
// part of the project; they are read from RIG_SHARED_DIR (default: ../shared beside the source tree).
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/ingestion/record_reader.hpp"

namespace {

using diagnosis::Diagnosis;

class MeasuredRigs : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* set = std::getenv("RIG_SHARED_DIR");
    shared_ = set ? std::string(set) : std::string(SOURCE_DIR) + "/../shared";
    if (!std::filesystem::exists(shared_ + "/measured")) GTEST_SKIP() << "no recordings in " << shared_ << "/measured";
  }
  Diagnosis diagnosed(const std::string& rig_file, const std::vector<std::string>& data,
                      const std::vector<std::string>& holdout) {
    const std::string folder =
        std::filesystem::exists(shared_ + "/contract/" + rig_file) ? "/contract/" : "/measured/rigs/";
    rig_file::RigModel rig = rig_file::read_rig_file(shared_ + folder + rig_file);
    if (without_coulomb_) rig.links[0].coulomb_N = {};
    return diagnosis::diagnose(rig, read(data, rig), read(holdout, rig));
  }
  static std::vector<std::string> names(const Diagnosis& d) {
    std::vector<std::string> list;
    for (const diagnosis::Cause& c : d.causes) list.push_back(c.effect + " on " + c.where);
    return list;
  }
  bool without_coulomb_ = false;

 private:
  std::vector<host_sim::Record> read(const std::vector<std::string>& files, const rig_file::RigModel& rig) {
    std::vector<host_sim::Record> list;
    for (const std::string& file : files) list.push_back(host_sim::read_record(shared_ + "/measured/" + file, rig));
    return list;
  }
  std::string shared_;
};

using Names = std::vector<std::string>;

TEST_F(MeasuredRigs, DriveWithViscousFrictionThatDependsOnTheDirection) {
  const Diagnosis d = diagnosed("emps.toml", {"emps.csv"}, {});
  EXPECT_EQ(names(d), Names{"asymmetric_viscous on link 1-0"});
  // runs of one second from the measured state, on the last 30 %
  EXPECT_GT(d.baseline.holdout_velocity_nrmse_percent[0], 5 * d.extended.holdout_velocity_nrmse_percent[0]);
  // a sixth of the error of runs of a second remains, less of a window's square, and none of it is noise
  EXPECT_EQ(d.verdict, diagnosis::Verdict::kPartly);
  EXPECT_LT(d.causes.at(0).explains_percent, 99.9);
  EXPECT_GT(d.causes.at(0).explains_percent, 98);
  // published by the benchmark's authors: 166.71 and 240.42 N s/m
  double mean = 0, half_difference = 0;
  for (const diagnosis::Parameter& p : d.extended.parameters) {
    if (p.name == "viscous[1-0]") mean = p.value;
    if (p.name == "asymmetric_viscous[1-0]") half_difference = p.value;
  }
  EXPECT_NEAR(mean + half_difference, 166.71, 0.1 * 166.71);
  EXPECT_NEAR(mean - half_difference, 240.42, 0.1 * 240.42);
}

TEST_F(MeasuredRigs, PendulumWithQuadraticDrag) {
  const Diagnosis d = diagnosed("pendulum.toml", {"pendulum_free_swing.csv"}, {});
  EXPECT_EQ(names(d), Names{"quadratic_damping on link 1-0"});
  EXPECT_GT(d.gain[0], 2);
}

TEST_F(MeasuredRigs, PendulumOfItsAuthorsHasViscousFrictionOnly) {
  without_coulomb_ = true;
  const Diagnosis d = diagnosed("pendulum.toml", {"pendulum_free_swing.csv"}, {});
  // Two terms are missing that look alike in one decay. Where they are named it has to be these; naming neither is a known
  // shortfall (docs/diagnosis_method.md), naming another would be a false accusation.
  if (!names(d).empty()) {
    EXPECT_EQ(names(d), (Names{"missing_coulomb on link 1-0", "quadratic_damping on link 1-0"}));
    EXPECT_GT(d.gain[0], 2);
  }
}

TEST_F(MeasuredRigs, DamperWithStaticForceAndHysteresis) {
  const Diagnosis d = diagnosed(
      "mr_damper.toml", {"mr_damper_0V_record_01.csv", "mr_damper_0V_record_03.csv", "mr_damper_0V_record_05.csv"},
      {"mr_damper_0V_record_07.csv", "mr_damper_0V_record_09.csv"});
  EXPECT_EQ(names(d), (Names{"force_offset on link 1-0", "presliding_hysteresis on link 1-0"}));
  EXPECT_GT(d.gain[0], 10);
}

bool said(const Diagnosis& d, const std::string& effect) {
  for (const diagnosis::Cause& c : d.causes)
    if (c.effect == effect) return true;
  for (const diagnosis::NamedPlace& p : d.ambiguous_with)
    if (p.effect == effect) return true;
  return false;
}

// References: a separate program's, see the recordings' own page.
TEST_F(MeasuredRigs, RacingDamperWithHysteresisAndGasPressure) {
  const Diagnosis d = diagnosed("racing_damper.toml", {"racing_damper_cold_3_3.csv"}, {});
  EXPECT_TRUE(said(d, "presliding_hysteresis"));
  EXPECT_TRUE(said(d, "force_offset"));
  EXPECT_GT(d.gain[0], 2);  // half of the reference's 30 -> 7.7, in logarithms
}

TEST_F(MeasuredRigs, BandedDampersWithHysteresis) {
  struct Case {
    const char* file;
    double gain;  // half of the reference's 90 -> 33 and 70 -> 21, in logarithms
  };
  for (const Case& c : {Case{"friction_damper_1Hz_20lb.csv", 1.65}, Case{"friction_damper_0p5Hz_30lb.csv", 1.82}}) {
    const Diagnosis d = diagnosed("friction_damper.toml", {c.file}, {});
    EXPECT_EQ(names(d), Names{"presliding_hysteresis on link 1-0"}) << c.file;
    EXPECT_GT(d.gain[0], c.gain) << c.file;
  }
}

TEST_F(MeasuredRigs, WeightThatRubs) {
  const Diagnosis d = diagnosed("spring_weight.toml", {"spring_weight_rubbing.csv"}, {});
  EXPECT_TRUE(said(d, "missing_coulomb"));
  EXPECT_GT(d.gain[0], 2.4);  // half of 29 -> 5.2
}

TEST_F(MeasuredRigs, NothingIsNamedThatIsNotDecidable) {
  EXPECT_TRUE(diagnosed("spring_weight.toml", {"spring_weight_drag.csv"}, {}).causes.empty());
  const std::vector<std::string> command = {"servo_pair_command_1.csv", "servo_pair_command_2.csv"};
  EXPECT_TRUE(diagnosed("servo_pair.toml", command, {}).causes.empty());
  const std::vector<std::string> measured = {"servo_pair_measured_torque_1.csv", "servo_pair_measured_torque_2.csv"};
  EXPECT_TRUE(diagnosed("servo_pair.toml", measured, {}).causes.empty());
}

TEST_F(MeasuredRigs, WingOfTenModesIsToldThatThreeMassesCannotDescribeIt) {
  const Diagnosis d = diagnosed("f16_wing.toml", {"f16_wing_level_1.csv"}, {});
  EXPECT_EQ(d.verdict, diagnosis::Verdict::kUnknown);
  ASSERT_FALSE(d.advice.empty());
  EXPECT_NE(d.cannot_describe.find("its simulation misses"), std::string::npos) << d.cannot_describe;
  EXPECT_TRUE(d.baseline.parameters.empty());
  for (double nrmse : d.baseline.holdout_nrmse_percent) EXPECT_LE(nrmse, 1000);
}

}  // namespace
