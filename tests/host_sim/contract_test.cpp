// The shapes that tools outside the project rely on, judged by the checker that comes with them.
#include "tests/host_sim/program_test.hpp"

namespace {

class Contract : public test_support::ProgramTest {
 protected:
  void expect_kept(const std::string& parts) {
    const auto shared = test_support::shared_folder();
    if (shared.empty() || !std::filesystem::exists(shared / "contract" / "check.py"))
      GTEST_SKIP() << "no contract/check.py in RIG_SHARED_DIR";
    const auto bin = std::filesystem::path(HOST_SIM).parent_path();
    const auto result = test_support::run_program({"python3", shared / "contract" / "check.py", bin, "--only", parts},
                                                  workspace_.path());
    EXPECT_EQ(result.status, 0) << result.output << result.errors;
  }
};

TEST_F(Contract, EstimateDecodeDbcAndErrors) { expect_kept("estimate,run,decode,dbc,errors"); }

TEST_F(Contract, Diagnose) { expect_kept("diagnose"); }

}  // namespace
