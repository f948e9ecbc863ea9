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

// What is said of two files is said once, with both their names.
TEST_F(Estimate, ANoteNamesEveryFileThatItIsOf) {
  workspace_.write("more.csv", workspace_.read("data.csv"));
  const auto two =
      host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--data", "more.csv", "--from", "1"});
  EXPECT_EQ(two.status, 0) << two.errors;
  EXPECT_NE(two.errors.find("data.csv and more.csv: taken from 1 to "), std::string::npos) << two.errors;
  const auto bad =
      host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--data", "none.csv", "--from", "1"});
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.errors.find("data.csv: taken from 1 to "), std::string::npos) << bad.errors;
}

// A name in Latin-1, as an old disk has it: the JSON is UTF-8 all the same.
TEST_F(Estimate, AFileNameThatIsNoUtf8) {
  const std::string name = "m\xfcller.csv";
  workspace_.write(name, workspace_.read("data.csv"));
  const auto check = host_sim({"check", "--data", name, "--json", "check.json"});
  EXPECT_EQ(check.status, 0) << check.errors;
  EXPECT_NE(json("check.json").dump().find("m\xef\xbf\xbdller.csv"), std::string::npos);
  const auto estimate =
      host_sim({"estimate", "--rig", "rig.toml", "--data", name, "--json", "e.json", "--report", "r"});
  EXPECT_EQ(estimate.status, 0) << estimate.errors;
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
