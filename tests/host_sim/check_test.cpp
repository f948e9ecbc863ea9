// host_sim check, and the same check before estimate and diagnose: the mistakes that people make end with status 3 and
// their plain names; recordings of other programs are read with what the user says about them.
#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/host_sim/program_test.hpp"

namespace {

using test_support::ProgramResult;
using test_support::ProgramTest;

constexpr const char* kRig =
    "schema = \"rig/1\"\nname = \"mass on a spring\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\n"
    "stiffness_N_m = 800.0\nviscous_N_s_m = \"estimate\"\ncoulomb_N = \"estimate\"\n";

constexpr const char* kShaker =
    "schema = \"scenario/1\"\nname = \"mass on a spring\"\nrig = \"rig.toml\"\n[truth]\n\"viscous[1-0]\" = 4.0\n"
    "\"coulomb[1-0]\" = 2.0\n[[level]]\nkind = \"random\"\nrms_N = 10.0\nband_Hz = [1.0, 20.0]\nduration_s = 10.0\n"
    "[[level]]\nkind = \"random\"\nrms_N = 30.0\nband_Hz = [1.0, 20.0]\nduration_s = 10.0\n"
    "[sensors]\nbits = 16\nnoise_percent = 1.0\n";

using Rows = std::vector<std::vector<std::string>>;  // [0] the heads

class Check : public ProgramTest {
 protected:
  void SetUp() override {
    workspace_.write("rig.toml", kRig);
    workspace_.write("shaker.toml", kShaker);
    ASSERT_EQ(host_sim({"run", "--scenario", "shaker.toml", "--records", "m", "--log", "/dev/null"}).status, 0);
  }

  Rows rows(const std::string& file) const {
    Rows result;
    std::string field, text = workspace_.read(file);
    result.emplace_back();
    for (const char c : text) {
      if (c != ',' && c != '\n') {
        field += c;
        continue;
      }
      result.back().push_back(field);
      field.clear();
      if (c == '\n') result.emplace_back();
    }
    result.pop_back();
    return result;
  }
  void write(const std::string& file, const Rows& table, char separator = ',') const {
    std::string text;
    for (const auto& row : table)
      for (size_t i = 0; i < row.size(); ++i) text += row[i] + (i + 1 == row.size() ? '\n' : separator);
    workspace_.write(file, text);
  }
  static size_t column(const Rows& table, const std::string& head) {
    for (size_t i = 0; i < table[0].size(); ++i)
      if (table[0][i] == head) return i;
    ADD_FAILURE() << head;
    return 0;
  }
  // level_1 with the channel's values changed.
  void spoil(const std::string& head, const std::function<double(double, size_t)>& change) const {
    Rows table = rows("m/level_1.csv");
    const size_t place = column(table, head);
    for (size_t i = 1; i < table.size(); ++i) {
      char text[40];
      std::snprintf(text, sizeof text, "%.12g", change(std::stod(table[i][place]), i));
      table[i][place] = text;
    }
    write("bad.csv", table);
  }
  ProgramResult estimate(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"estimate", "--rig", "rig.toml", "--data", "bad.csv", "--json", "out.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return host_sim(arguments);
  }
};

TEST_F(Check, SoundRecordsAreGood) {
  const ProgramResult result = host_sim(
      {"check", "--rig", "rig.toml", "--data", "m/level_1.csv", "--data", "m/level_2.csv", "--json", "check.json"});
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("verdict: good"), std::string::npos) << result.output;
  const auto check = json("check.json");
  EXPECT_EQ(check["schema"], "check/1");
  EXPECT_EQ(check["verdict"], "good");
  EXPECT_EQ(check["records"].size(), 2u);
}

TEST_F(Check, FaultsEndEstimateAndDiagnoseWithTheirNames) {
  struct Mistake {
    const char* kind;
    const char* head;
    std::function<double(double, size_t)> change;
  };
  const Mistake mistakes[] = {
      {"dead", "displacement_1_m", [](double, size_t) { return 0.0; }},
      {"spikes", "displacement_1_m", [](double x, size_t i) { return i == 4000 ? 1e30 : x; }},
      {"polarity", "acceleration_1_m_s2", [](double x, size_t) { return -x; }},
      {"unit", "acceleration_1_m_s2", [](double x, size_t) { return x / 9.80665; }},
      {"unit", "force_1_N", [](double x, size_t) { return x / 1000.0; }},
      {"clipped", "acceleration_1_m_s2", [](double x, size_t) { return std::min(std::max(x, -5.0), 5.0); }},
  };
  for (const Mistake& mistake : mistakes) {
    SCOPED_TRACE(std::string(mistake.kind) + " " + mistake.head);
    spoil(mistake.head, mistake.change);
    const ProgramResult result = estimate();
    EXPECT_EQ(result.status, 3) << result.errors;
    EXPECT_NE(result.errors.find(std::string(mistake.head) + ": " + mistake.kind + ":"), std::string::npos)
        << result.errors;
    EXPECT_EQ(workspace_.entries().count("out.json"), 0u);
  }
  EXPECT_EQ(host_sim({"diagnose", "--rig", "rig.toml", "--data", "bad.csv"}).status, 3);
  EXPECT_EQ(host_sim({"check", "--data", "bad.csv"}).status, 3);
  const ProgramResult anyway = estimate({"--anyway"});
  EXPECT_NE(anyway.status, 2);
  EXPECT_NE(anyway.errors.find("clipped:"), std::string::npos) << anyway.errors;
  EXPECT_EQ(workspace_.entries().count("out.json"), 1u);
}

TEST_F(Check, NoResultTakesTheRigFilesPlace) {
  const std::string rig = workspace_.read("rig.toml");
  const auto result = host_sim({"check", "--rig", "rig.toml", "--data", "m/level_1.csv", "--json", "./rig.toml"});
  EXPECT_NE(result.status, 0);
  EXPECT_NE(result.errors.find("is read by this command"), std::string::npos) << result.errors;
  EXPECT_EQ(workspace_.read("rig.toml"), rig);
}

// The same record as another program would have written it gives the same numbers.
TEST_F(Check, ARecordOfAnotherProgramGivesTheSameEstimate) {
  Rows table = rows("m/level_2.csv");
  write("bad.csv", table);
  ASSERT_EQ(estimate().status, 0);
  const double expected = value(json("out.json"), "viscous[1-0]");
  const size_t acceleration = column(table, "acceleration_1_m_s2"), force = column(table, "force_1_N");
  for (size_t i = 1; i < table.size(); ++i) {
    for (const auto& [place, factor] : {std::pair<size_t, double>{acceleration, 1 / 9.80665}, {force, 1e-3}}) {
      char text[40];
      std::snprintf(text, sizeof text, "%.15g", std::stod(table[i][place]) * factor);
      table[i][place] = text;
    }
    for (std::string& field : table[i]) std::replace(field.begin(), field.end(), '.', ',');
    table[i].push_back("ok");
  }
  table[0][acceleration] = "Chan 3";
  table[0][force] = "force_1_kN";
  table[0].push_back("remark");
  write("bad.csv", table, ';');
  const ProgramResult result = estimate({"--column", "acceleration_1=Chan 3", "--unit", "acceleration_1=g"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NEAR(value(json("out.json"), "viscous[1-0]"), expected, 1e-6 * expected);
  EXPECT_NE(result.errors.find("acceleration_1_m_s2 from column \"Chan 3\" in g: values times 9.80665"),
            std::string::npos);
  EXPECT_NE(result.errors.find("ignored: \"remark\""), std::string::npos);
  EXPECT_EQ(estimate({"--column", "nonsense"}).status, 2);
}

TEST_F(Check, AFullDiskIsNoticed) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  spoil("force_1_N", [](double x, size_t) { return x; });
  const std::string command = HOST_SIM;
  for (const std::string& arguments :
       {std::string(" check --data bad.csv"), std::string(" check --data bad.csv --json -"),
        std::string(" estimate --rig rig.toml --data bad.csv"),
        std::string(" estimate --rig rig.toml --data bad.csv --json -")}) {
    const ProgramResult result =
        test_support::run_program({"/bin/sh", "-c", command + arguments + " > /dev/full"}, workspace_.path());
    EXPECT_EQ(result.status, 2) << arguments << result.errors;
    EXPECT_NE(result.errors.find("cannot be written"), std::string::npos) << arguments << result.errors;
  }
}

}  // namespace
