// What the end-to-end tests share: the program, its JSON, a rig with a known answer.
#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/host_sim/run_program.hpp"

namespace test_support {

// A line of a data file, twelve digits each.
inline std::string row(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ",") + fmt::format("{:.12g}", value);
  return text + "\n";
}

class ProgramTest : public ::testing::Test {
 protected:
  // host_sim with these arguments, in the test's own folder.
  ProgramResult host_sim(std::vector<std::string> arguments, const std::string& input = "") const {
    arguments.insert(arguments.begin(), HOST_SIM);
    return run_program(arguments, workspace_.path(), input);
  }
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(workspace_.read(name)); }
  // Value of a parameter of an estimate.
  static double value(const nlohmann::json& estimate, const std::string& name) {
    for (const auto& parameter : estimate["parameters"])
      if (parameter["name"] == name) return parameter["value"];
    ADD_FAILURE() << name << " is not in the result";
    return 0.0;
  }
  Workspace workspace_;
};

}  // namespace test_support
