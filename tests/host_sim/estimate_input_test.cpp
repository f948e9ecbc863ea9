// host_sim estimate and the files and options that it is given.
#include <cmath>
#include <set>
#include <vector>

#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;
using test_support::row;

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
  const auto thrice = host_sim(
      {"estimate", "--rig", "rig.toml", "--data", "data.csv", "--data", "./data.csv", "--data", "././data.csv"});
  EXPECT_NE(thrice.errors.find("././data.csv: is given 3 times and counts as 3 measurements"), std::string::npos);
  EXPECT_EQ(thrice.errors.find("twice"), std::string::npos) << thrice.errors;
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

TEST_F(Estimate, WhatIsNoNumberIsRefusedByTheNameOfItsOption) {
  const auto with = [&](const std::string& option, const std::string& text) {
    return host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", option, text});
  };
  for (const char* option : {"--from", "--to", "--sample-rate", "--resample"}) {
    const auto result = with(option, "nan");
    EXPECT_EQ(result.status, 2) << option;
    EXPECT_NE(result.errors.find(option), std::string::npos) << result.errors;
    EXPECT_EQ(result.errors.find("internal"), std::string::npos) << result.errors;
  }
  for (const char* option : {"--sample-rate", "--resample"}) {
    const auto result = with(option, "inf");
    EXPECT_EQ(result.status, 2) << option;
    EXPECT_NE(result.errors.find("expected a number above 0"), std::string::npos) << result.errors;
  }
  EXPECT_EQ(with("--to", "inf").status, 0);
}

TEST_F(Estimate, TwoResultsInOneFileAreRefused) {
  const auto result =
      host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", "f.json", "--log", "./f.json"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("is to hold two results of this command"), std::string::npos) << result.errors;
  EXPECT_EQ(workspace_.entries(), (std::set<std::string>{"data.csv", "rig.toml"}));
}

// A displacement with a little noise (digits of a fixed pattern) and its central differences. A long record tells that these
// were computed, a short one is too short to: the column is left out in both.
TEST_F(Estimate, AColumnComputedInOneRecordIsLeftOutInAll) {
  const auto record_of = [](int rows) {
    std::vector<double> x;
    for (int i = 0; i < rows; ++i) x.push_back(0.01 * std::cos(0.02 * i) + 1e-6 * ((i * 7919) % 13 - 6));
    std::string text = "t_s,displacement_1_m,velocity_1_m_s\n";
    for (int i = 1; i + 1 < rows; ++i) {
      const size_t k = static_cast<size_t>(i);
      text += row({i * 1e-3, x[k], (x[k + 1] - x[k - 1]) / 2e-3});
    }
    return text;
  };
  workspace_.write("long.csv", record_of(4000));
  workspace_.write("short.csv", record_of(60));
  const std::string note = "velocity_1_m_s: was computed from another column in long.csv: left out here too";
  const auto estimate = host_sim({"estimate", "--rig", "rig.toml", "--data", "short.csv", "--data", "long.csv"});
  EXPECT_EQ(estimate.errors.find("expected the same channels"), std::string::npos) << estimate.errors;
  EXPECT_NE(estimate.errors.find("short.csv: " + note), std::string::npos) << estimate.errors;
  const auto diagnose = host_sim({"diagnose", "--rig", "rig.toml", "--data", "long.csv", "--holdout", "short.csv"});
  EXPECT_EQ(diagnose.errors.find("expected the same channels"), std::string::npos) << diagnose.errors;
  EXPECT_NE(diagnose.errors.find("short.csv: " + note), std::string::npos) << diagnose.errors;
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
