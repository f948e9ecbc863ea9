// host_sim run: shaker, rig and sensors simulated, every sample through the fixed-point core, the estimates as CAN
// frames.
#include <algorithm>
#include <cctype>

#include "host_sim/plant/plant_error.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/estimate/estimate_report_data.hpp"
#include "host_sim/programs/results/result_json.hpp"
#include "host_sim/programs/results/result_table.hpp"
#include "host_sim/programs/run/can_output.hpp"
#include "host_sim/programs/run/record_export.hpp"
#include "host_sim/programs/run/run_result.hpp"
#include "host_sim/programs/shared/human_output.hpp"
#include "host_sim/programs/shared/inputs.hpp"
#include "host_sim/programs/shared/one_heap.hpp"
#include "host_sim/programs/shared/terminal.hpp"
#include "host_sim/reports/data/from_run.hpp"
#include "host_sim/reports/page/report.hpp"

namespace host_sim {
namespace {

struct RunArguments {
  std::string scenario = "paper_3dof_random";
  std::string can, log, json, report, records;
  uint64_t seed = 1;
  bool print = false;
};

// Frames to their sink, progress to the terminal.
class RunSink : public ProgressSink {
 public:
  explicit RunSink(FrameSink& sink) : sink_(sink), bar_("simulating") {}

  void progress(double share) override { bar_.show(share); }
  void frame(const hal::CanFrame& frame) override {
    sink_.until(frame.time_ns);
    sink_.write(frame);
  }

 private:
  FrameSink& sink_;
  ProgressBar bar_;
};

// "my rig!" -> "my_rig_.log"
std::string default_log_name(const Scenario& scenario) {
  std::string name = scenario.name.empty() ? "run" : scenario.name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '-'; }, '_');
  return name + ".log";
}

std::unique_ptr<FrameSink> open_sink(const RunArguments& arguments, const std::string& log) {
  if (!arguments.can.empty()) return socket_can_sink(arguments.can);
  return log == "-" ? stdout_sink("vcan0") : log_file_sink(log, "vcan0");
}

void print_summary(std::FILE* stream, const Scenario& scenario, const RunArguments& arguments,
                   const EstimateResult& result) {
  const std::string head = wrapped(scenario.name + ": " + scenario.description, wrap_width(stream), "  ");
  std::fprintf(stream, "%s\n%zu samples at %g Hz, %u level%s, seed %llu\n\n%s", head.c_str(), result.samples,
               result.sample_rate_Hz, result.levels, result.levels == 1 ? "" : "s",
               static_cast<unsigned long long>(arguments.seed),
               format_table(result, is_terminal(stream), wrap_width(stream)).c_str());
}

void write_report(const RunArguments& arguments, const Scenario& scenario, const RunResult& outcome,
                  const std::vector<reports::Convergence>& convergence, const EstimateResult& result) {
  reports::RunReportData data = reports::run_report_data(scenario, arguments.seed, outcome, convergence);
  data.warrant = warrant_view(result.warrant);
  data.check = data_check::check(outcome.measured.measured, &scenario.rig);
  reports::write_run_report(arguments.report, data);
}

void print_shipped(const std::string& name) {
  const std::string text = shipped_scenario_text(name);
  if (text.empty())
    throw UsageError(name + " is not shipped, expected one of the names that host_sim run --help lists");
  std::fputs(text.c_str(), stdout);
}

void run(const RunArguments& arguments) {
  use_one_heap();
  if (arguments.print) return print_shipped(arguments.scenario);
  if (!arguments.can.empty() && !arguments.log.empty())
    throw UsageError("--can and --log stand together, expected one of them");
  const Scenario scenario = read_scenario(arguments.scenario);
  reports::require_place(arguments.report);
  const std::string log = arguments.log.empty() ? default_log_name(scenario) : arguments.log;
  if (log == "-" && arguments.json == "-") throw UsageError("two results are to go to stdout, expected \"-\" once");
  std::FILE* const people = log == "-" || arguments.json == "-" ? stderr : stdout;
  ResultTarget json(arguments.json);
  const std::unique_ptr<FrameSink> sink = open_sink(arguments, log);
  RunResult outcome;
  std::vector<reports::Convergence> convergence;
  try {
    RunSink run_sink(*sink);
    reports::ConvergenceRecorder recorder(run_sink);
    outcome = run_scenario(scenario, arguments.seed, recorder);
    convergence = recorder.convergence();
  } catch (const PlantError& error) {
    throw UsageError(arguments.scenario + ": " + error.what());
  }
  const EstimateResult result = result_of_run(scenario, outcome);
  if (!arguments.report.empty()) write_report(arguments, scenario, outcome, convergence, result);
  if (!arguments.records.empty()) {
    export_records(arguments.records, scenario, outcome);
    for (const std::string& name : levels_of_others(arguments.records, scenario.levels.size()))
      std::fprintf(stderr, "note: %s/%s is not of this run\n", arguments.records.c_str(), name.c_str());
  }
  sink->commit();
  nlohmann::ordered_json content = to_json(result);
  content["scenario"] = scenario.name;
  content["seed"] = arguments.seed;
  json.deliver(to_text(content));
  print_summary(people, scenario, arguments, result);
  if (arguments.can.empty() && log != "-")
    std::fprintf(people, "frames: %s (host_sim decode %s)\n", log.c_str(), log.c_str());
  if (!arguments.records.empty()) std::fprintf(people, "measurements: %s\n", arguments.records.c_str());
  if (!arguments.report.empty()) std::fprintf(people, "report: %s/index.html\n", arguments.report.c_str());
  const std::string missing = unanswered(result);
  if (!missing.empty()) throw CannotAnswer(missing);
}

// CLI11 would take -1 for the largest number there is.
const CLI::Validator whole_number(
    [](const std::string& text) {
      const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
      return digits ? "" : "\"" + text + "\" is no seed, expected a whole number from 0";
    },
    "");

}  // namespace

void add_run_command(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("run", "Simulate shaker, rig and sensors; estimate; send the estimates as CAN frames");
  auto arguments = std::make_shared<RunArguments>();
  std::string names;
  for (const std::string& name : shipped_scenario_names()) names += "\n  " + name;
  command->add_option("--scenario", arguments->scenario, "shipped scenario or scenario file (TOML)")
      ->capture_default_str();
  command->add_flag("--print", arguments->print,
                    "print the shipped scenario as a file to start your own from, and stop");
  command->add_option("--can", arguments->can, "send the frames on this CAN interface, in real time");
  command->add_option("--log", arguments->log,
                      "write the frames as a candump log to this file (- is stdout); default: SCENARIO.log");
  command->add_option("--json", arguments->json, "write the result as JSON to this file (- is stdout)");
  command->add_option("--report", arguments->report, "write a page with pictures to this folder");
  command->add_option(
      "--records", arguments->records,
      "write the simulated measurements (CSV) and the rig file to this folder, for estimate and diagnose");
  command->add_option("--seed", arguments->seed, "of all random numbers; the same seed gives the same bytes")
      ->check(whole_number)
      ->capture_default_str();
  command->footer("Shipped scenarios:" + names +
                  "\nExample: host_sim run --scenario paper_2dof --log - | host_sim decode");
  command->callback([arguments, &chosen] { chosen = [arguments] { run(*arguments); }; });
}

}  // namespace host_sim
