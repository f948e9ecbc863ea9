// host_sim estimate and the files and options that it is given.
#include <set>

#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;

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

}  // namespace
