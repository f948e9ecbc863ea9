// Data files with one fault each, and command lines that cannot be followed.
#include <cmath>
#include <cstdio>
#include <functional>

#include "tests/bad_input/bad_input.hpp"

namespace bad_input {
namespace {

using Rows = std::vector<std::string>;  // [0] is the header, [i] stands on line i + 1

// m = 2 kg, k = 800 N/m (20 rad/s), c = 1.5 N s/m: the damped oscillator's own solution.
Rows good_rows() {
  const double decay = 1.5 / 4.0, turn = std::sqrt(400.0 - decay * decay);
  Rows rows = {"t_s,displacement_1_m,velocity_1_m_s"};
  for (int i = 0; i < 2000; ++i) {
    const double t = i * 1e-3, e = 0.01 * std::exp(-decay * t);
    char row[96];
    std::snprintf(row, sizeof row, "%.3f,%.9g,%.9g", t, e * std::cos(turn * t),
                  -e * (decay * std::cos(turn * t) + turn * std::sin(turn * t)));
    rows.push_back(row);
  }
  return rows;
}

std::string joined(const Rows& rows) {
  std::string text;
  for (const std::string& row : rows) text += row + "\n";
  return text;
}

Case data(const std::string& name, const std::string& content, std::vector<std::string> says) {
  says.push_back("data.csv");
  return Case{name, {{"rig.toml", good_rig()}, {"data.csv", content}}, estimate_command(), "", std::move(says)};
}
Case spoilt(const std::string& name, const std::function<void(Rows&)>& spoil, std::vector<std::string> says) {
  Rows rows = good_rows();
  spoil(rows);
  return data(name, joined(rows), std::move(says));
}
Case header(const std::string& name, const std::string& first_line, std::vector<std::string> says) {
  says.push_back("data.csv:1");
  return spoilt(
      name, [&](Rows& rows) { rows[0] = first_line; }, std::move(says));
}
Case two_files(const std::string& name, const std::string& second, std::vector<std::string> says) {
  Case result = data(name, good_data(), std::move(says));
  result.says.back() = "second.csv";
  result.files["second.csv"] = second;
  result.arguments.insert(result.arguments.end(), {"--data", "second.csv"});
  return result;
}
// Whole cycles of a rig file that stands beside it; `rest` follows.
Case scenario(const std::string& name, const std::string& rest, std::vector<std::string> says) {
  says.push_back("shaker.toml");
  const std::string text = "schema = \"scenario/1\"\nrig = \"rig.toml\"\n" + rest + "[truth]\n\"viscous[1-0]\" = 1.5\n";
  return Case{name,
              {{"rig.toml", good_rig()}, {"shaker.toml", text}},
              {"run", "--scenario", "shaker.toml", "--json", "out.json", "--log", "out.log", "--records", "measured"},
              "",
              std::move(says)};
}
const std::string kLevel = "[[level]]\nkind = \"sine\"\namplitude_N = 1\nfrequency_Hz = 2\ncycles = 10\n";

Case command(const std::string& name, std::vector<std::string> arguments, std::vector<std::string> says) {
  return Case{name, {{"rig.toml", good_rig()}, {"data.csv", good_data()}}, std::move(arguments), "", std::move(says)};
}

}  // namespace

std::string good_data() { return joined(good_rows()); }

std::vector<std::string> estimate_command() {
  return {"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", "out.json", "--log", "out.log"};
}

std::vector<Case> broken_data() {
  return {
      data("DataIsEmpty", "", {"is empty"}),
      data("DataIsBlank", "\n \n\n", {"is empty"}),
      data("DataHasOnlyAHeader", "t_s,displacement_1_m\n", {"0 samples"}),
      data("DataHasOneSample", "t_s,displacement_1_m\n0,1\n", {"1 sample"}),
      data("DataIsBinary", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), {"expected"}),
      header("NoColumnIsTime", "displacement_1_m,x,velocity_1_m_s", {"expected t_s", "--sample-rate"}),
      spoilt("HeadsSeparatedBySemicolons", [](Rows& rows) { rows[0] = "t_s;displacement_1_m;velocity_1_m_s"; },
             {"data.csv:2", "separated by semicolons"}),
      header("ChannelWithoutMeaning", "t_s,wobble_1_m,velocity_1_m_s", {"wobble_1_m"}),
      header("ChannelMisspelt", "t_s,displacment_1_m,velocity_1_m_s", {"did you mean \"displacement_1_m\""}),
      header("ChannelWithoutUnit", "t_s,displacement_1,velocity_1_m_s", {"did you mean \"displacement_1_m\""}),
      header("ChannelInParsecs", "t_s,displacement_1_pc,velocity_1_m_s", {"did you mean \"displacement_1_m\""}),
      header("ChannelOfDofZero", "t_s,displacement_0_m,velocity_1_m_s", {"displacement_0_m"}),
      header("ChannelOfDofNotInRig", "t_s,displacement_7_m,velocity_1_m_s", {"DOF 7", "expected 1 to 1"}),
      header("ChannelOfBaseNotInRig", "t_s,displacement_base_m,velocity_1_m_s", {"base"}),
      header("ChannelOfRotation", "t_s,angle_1_rad,velocity_1_m_s", {"expected displacement_1_m"}),
      header("ChannelStandsTwice", "t_s,velocity_1_m_s,velocity_1_m_s", {"twice"}),
      spoilt("HeaderHasFewerColumns", [](Rows& rows) { rows[0] = "t_s,displacement_1_m"; },
             {"data.csv:2", "expected 2"}),
      header("OnlyTime", "t_s", {"no channel"}),
      spoilt("NoMotionRecorded",
             [](Rows& rows) {
               for (auto& row : rows) row = row == rows[0] ? "t_s,force_1_N" : row.substr(0, row.rfind(','));
             },
             {"no motion of DOF 1", "displacement_1_m"}),
      spoilt("NotANumber", [](Rows& rows) { rows[50] = "0.049,oops,0"; },
             {"data.csv:51", "displacement_1_m", "\"oops\""}),
      spoilt("DecimalComma", [](Rows& rows) { rows[50] = "0,049,0,1,0,2"; }, {"data.csv:51"}),
      spoilt("NotFinite", [](Rows& rows) { rows[50] = "0.049,nan,0"; }, {"data.csv:51", "\"nan\"", "finite"}),
      spoilt("Infinite", [](Rows& rows) { rows[50] = "0.049,0,-inf"; }, {"data.csv:51", "velocity_1_m_s", "finite"}),
      spoilt("TooLargeForAnyNumber", [](Rows& rows) { rows[50] = "0.049,0,1e999"; }, {"data.csv:51", "1e999"}),
      spoilt("FieldIsEmpty", [](Rows& rows) { rows[50] = "0.049,,0"; }, {"data.csv:51", "displacement_1_m"}),
      spoilt("FieldIsMissing", [](Rows& rows) { rows[50] = "0.049,0"; }, {"data.csv:51", "2 fields", "expected 3"}),
      spoilt("FieldTooMany", [](Rows& rows) { rows[50] = "0.049,0,0,0"; }, {"data.csv:51", "expected 3"}),
      spoilt("LineIsBlank", [](Rows& rows) { rows[50] = ""; }, {"data.csv:51", "blank"}),
      spoilt("LastLineIsCutOff", [](Rows& rows) { rows.back() = "1.999,0.0"; }, {"data.csv:2001", "2 fields"}),
      spoilt("SampleIsMissing", [](Rows& rows) { rows.erase(rows.begin() + 100); },
             {"data.csv:101", "constant step of 0.001 s"}),
      spoilt("SampleStandsTwice", [](Rows& rows) { rows.insert(rows.begin() + 100, rows[100]); },
             {"data.csv:102", "constant step"}),
      spoilt("TimeRunsBack", [](Rows& rows) { std::swap(rows[100], rows[101]); },
             {"data.csv:101", "constant step", "not in the order of time: sort them"}),
      spoilt("TimeStandsStill",
             [](Rows& rows) {
               for (auto& row : rows)
                 if (row != rows[0]) row = "0,0,0";
             },
             {"data.csv:3", "above 0"}),
      spoilt("StepOffByTwoPercent", [](Rows& rows) { rows[200] = "0.19902" + rows[200].substr(5); },
             {"data.csv:201", "within 1 %"}),
      two_files("SecondFileHasOtherChannels", "t_s,displacement_1_m\n0,1\n0.001,1\n0.002,1\n",
                {"velocity_1_m_s", "same channels"}),
      two_files("SecondFileHasOtherRate", "t_s,displacement_1_m,velocity_1_m_s\n0,1,1\n0.002,1,1\n0.004,1,1\n",
                {"sampled every", "0.001 s"}),
      two_files("SecondFileIsBroken", "t_s,displacement_1_m,velocity_1_m_s\n0,1,x\n", {"second.csv:2", "\"x\""}),
  };
}

std::vector<Case> broken_commands() {
  const auto estimate = [](std::vector<std::string> more) {
    std::vector<std::string> arguments = estimate_command();
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  return {
      command("NoCommand", {}, {"subcommand"}),
      command("UnknownCommand", {"estimat"}, {"estimat"}),
      command("EstimateWithoutOptions", {"estimate", "--json", "out.json"}, {"--rig"}),
      command("SampleRateIsNoRate",
              {"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", "out.json", "--sample-rate", "-5"},
              {"--sample-rate", "is \"-5\", expected a number above 0"}),
      command("EstimateWithoutData", {"estimate", "--rig", "rig.toml", "--json", "out.json"}, {"--data"}),
      command("OptionIsUnknown", estimate({"--jsno", "x"}), {"--jsno"}),
      command("OptionWithoutValue", estimate({"--frequency"}), {"--frequency"}),
      command("FrequencyIsText", estimate({"--frequency", "fast"}), {"--frequency"}),
      command("FrequencyIsNegative", estimate({"--frequency", "-5"}), {"--frequency"}),
      command("FrequencyBeyondSampling", estimate({"--frequency", "900"}), {"--frequency", "data.csv"}),
      command("RigFileIsMissing", {"estimate", "--rig", "nowhere.toml", "--data", "data.csv", "--json", "out.json"},
              {"nowhere.toml: does not exist, expected a TOML file"}),
      command("RigFileIsAFolder", {"estimate", "--rig", ".", "--data", "data.csv", "--json", "out.json"},
              {".: is a folder, expected a TOML file"}),
      command("DataFileIsMissing", {"estimate", "--rig", "rig.toml", "--data", "nowhere.csv", "--json", "out.json"},
              {"nowhere.csv"}),
      command("DataFileIsAFolder", {"estimate", "--rig", "rig.toml", "--data", ".", "--json", "out.json"},
              {"expected a readable data file"}),
      command("OutputFolderIsMissing", {"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", "no/out.json"},
              {"no/out.json", "writable"}),
      command("TwoResultsOnStdout",
              {"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", "-", "--log", "-"}, {"stdout"}),
      command("RigAndDataExchanged", {"estimate", "--rig", "data.csv", "--data", "rig.toml", "--json", "out.json"},
              {"data.csv:1", "TOML"}),
      command("LogToDecodeIsMissing", {"decode", "nowhere.log"}, {"nowhere.log"}),
      command("ScenarioIsUnknown", {"run", "--scenario", "paper_4dof", "--json", "out.json", "--log", "out.log"},
              {"paper_4dof", "paper_3dof_random"}),
      command("ScenarioFileIsARig", {"run", "--scenario", "rig.toml", "--json", "out.json", "--log", "out.log"},
              {"rig.toml:1", "schema", "scenario/1"}),
      scenario("ScenarioHasNoLevel", "", {"level"}),
      scenario("ScenarioLevelIsUnknown",
               "[[level]]\nkind = \"sinus\"\namplitude_N = 1\nfrequency_Hz = 2\ncycles = 10\n", {"kind", "sine"}),
      scenario("ScenarioKeyIsUnknown", kLevel + "[sensors]\nbitz = 16\n", {"bitz", "did you mean \"bits\""}),
      scenario("ScenarioNoiseIsNegative", kLevel + "[sensors]\nnoise_percent = -1.0\n", {"noise_percent"}),
      scenario("ScenarioLevelOfMissingDof",
               "[[level]]\nkind = \"sine\"\ndof = 4\namplitude_N = 1\nfrequency_Hz = 2\ncycles = 10\n",
               {"dof", "expected"}),
      command("CanAndLogTogether", {"run", "--can", "can0", "--log", "out.log"}, {"--can", "--log"}),
      command("CanInterfaceIsMissing", {"run", "--can", "no_such_can", "--json", "out.json"}, {"--log"}),
      command("SeedIsText", {"run", "--seed", "lucky", "--log", "out.log"}, {"--seed"}),
      command("RunLogFolderIsMissing", {"run", "--log", "no/out.log", "--json", "out.json"}, {"no/out.log"}),
      command("SweepWithoutSeeds", {"sweep", "--scenario", "paper_1dof", "--json", "out.json"}, {"--seeds"}),
      command("SweepSeedsRunBack", {"sweep", "--scenario", "paper_1dof", "--seeds", "9..1", "--json", "out.json"},
              {"--seeds", "FIRST..LAST"}),
      command("SweepSeedsAreOneNumber", {"sweep", "--scenario", "paper_1dof", "--seeds", "7", "--json", "out.json"},
              {"--seeds", "FIRST..LAST"}),
      command("SweepScenarioIsUnknown", {"sweep", "--scenario", "nope", "--seeds", "1..2", "--json", "out.json"},
              {"nope"}),
      command("SweepWorkersAreZero",
              {"sweep", "--scenario", "paper_1dof", "--seeds", "1..2", "--workers", "0", "--json", "out.json"},
              {"--workers"}),
      command("DiagnoseWithoutData", {"diagnose", "--rig", "rig.toml", "--json", "out.json"}, {"--data"}),
      command("DiagnoseDataIsMissing",
              {"diagnose", "--rig", "rig.toml", "--data", "nowhere.csv", "--json", "out.json", "--report", "page"},
              {"nowhere.csv"}),
      // before anything is read, which may take minutes to compute with
      command("ReportPlaceIsAFile", {"diagnose", "--rig", "rig.toml", "--data", "nowhere.csv", "--report", "data.csv"},
              {"data.csv: expected a folder for the report", "data.csv is no folder"}),
      command("ReportPlaceIsBehindAFile",
              {"estimate", "--rig", "rig.toml", "--data", "nowhere.csv", "--report", "data.csv/page"},
              {"data.csv/page: expected a folder for the report", "data.csv is no folder"}),
      command("DiagnoseHoldoutIsMissing",
              {"diagnose", "--rig", "rig.toml", "--data", "data.csv", "--holdout", "nowhere.csv", "--json", "out.json"},
              {"nowhere.csv"}),
  };
}

}  // namespace bad_input
