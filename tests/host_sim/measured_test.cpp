// Recordings of real rigs, made by others; they are not part of the project (RIG_SHARED_DIR says where they are).
#include <fstream>

#include "tests/host_sim/program_test.hpp"

namespace {

class Measured : public test_support::ProgramTest {
 protected:
  void SetUp() override {
    shared_ = test_support::shared_folder();
    if (shared_.empty()) GTEST_SKIP() << "no recordings: RIG_SHARED_DIR is not set and ../shared is absent";
  }
  nlohmann::json estimate(const std::string& rig, const std::vector<std::string>& data) {
    std::vector<std::string> arguments = {"estimate", "--rig", shared_ / "contract" / rig, "--json", "out.json"};
    for (const std::string& file : data) {
      arguments.emplace_back("--data");
      arguments.push_back(shared_ / "measured" / file);
    }
    const auto result = host_sim(arguments);
    EXPECT_EQ(result.status, 0) << result.errors;
    return json("out.json");
  }
  std::filesystem::path shared_;
};

// Published for these data: 95.1089 kg, 203.5034 N s/m, 20.3935 N; independent fits differ by up to 5.6 %.
TEST_F(Measured, LinearDriveAgreesWithThePublishedValues) {
  const auto out = estimate("emps.toml", {"emps.csv"});
  EXPECT_NEAR(value(out, "mass[1]"), 95.1089, 0.056 * 95.1089);
  EXPECT_NEAR(value(out, "viscous[1-0]"), 203.5034, 0.056 * 203.5034);
  EXPECT_NEAR(value(out, "coulomb[1-0]"), 20.3935, 0.056 * 20.3935);
}

// The authors: w0^2 = 64.2 1/s^2 per unit inertia. Their damping is viscous alone, so only its sign is to be compared.
TEST_F(Measured, PendulumFindsItsGravityAndLosesEnergy) {
  const auto out = estimate("pendulum.toml", {"pendulum_free_swing.csv"});
  EXPECT_NEAR(value(out, "gravity_torque[1-0]"), 64.2, 0.01 * 64.2);
  EXPECT_GT(value(out, "viscous[1-0]") + value(out, "coulomb[1-0]"), 0.0);
}

// Force against imposed motion, no inertia. The rig file as given lacks the damper's static force of some 130 N, whose
// work comes and goes within a cycle: numbers come, but the answer may be that these equations cannot tell.
TEST_F(Measured, DamperRecordsRun) {
  const auto result = host_sim({"estimate", "--rig", shared_ / "contract" / "mr_damper.toml", "--data",
                                shared_ / "measured" / "mr_damper_0V_record_01.csv", "--data",
                                shared_ / "measured" / "mr_damper_0V_record_09.csv", "--json", "out.json"});
  EXPECT_TRUE(result.status == 0 || result.status == 3) << result.errors;
  const auto out = json("out.json");
  EXPECT_EQ(out["samples"], 2713 + 2703);
  EXPECT_NE(out["mse_of"].get<std::string>().find("force"), std::string::npos);  // a massless rig has no free run
}

// With the static force named, viscous + Coulomb is a fair model. Plain fits of single records (least squares of the
// force on rate, sign and 1) lie between 980 and 1170 N s/m, 39 and 50 N, 133 and 139 N.
TEST_F(Measured, DamperWithItsStaticForceIsAnswered) {
  std::ifstream given(shared_ / "contract" / "mr_damper.toml");
  const std::string rig((std::istreambuf_iterator<char>(given)), std::istreambuf_iterator<char>());
  workspace_.write("rig.toml", rig + "[[link.effect]]\nkind = \"force_offset\"\ncoefficient = \"estimate\"\n");
  const auto result =
      host_sim({"estimate", "--rig", "rig.toml", "--data", shared_ / "measured" / "mr_damper_0V_record_01.csv",
                "--data", shared_ / "measured" / "mr_damper_0V_record_09.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto out = json("out.json");
  EXPECT_NEAR(value(out, "viscous[1-0]"), 1075.0, 300.0);
  EXPECT_NEAR(value(out, "coulomb[1-0]"), 44.0, 15.0);
  EXPECT_NEAR(value(out, "force_offset[1-0]"), 136.0, 15.0);
}

}  // namespace
