// host_sim estimate: measured data through the fixed-point core, as the board would.
#include "hal/rig_file/rig_reader.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/estimate/estimation.hpp"
#include "host_sim/programs/results/result_json.hpp"
#include "host_sim/programs/results/result_table.hpp"
#include "host_sim/programs/shared/human_output.hpp"
#include "host_sim/programs/shared/terminal.hpp"
#include "host_sim/records/record_reader.hpp"

namespace host_sim {
namespace {

struct EstimateArguments {
  std::string rig;
  std::vector<std::string> data;
  std::string json, log;
  double frequency_Hz = 0.0;
};

void print_table(std::FILE* stream, const rig_file::RigModel& model, const EstimateResult& result) {
  const bool colours = is_terminal(stream);
  std::fprintf(stream, "%s\n%zu samples at %g Hz, %u record%s\n\n%s", model.name.c_str(), result.samples,
               result.sample_rate_Hz, result.levels, result.levels == 1 ? "" : "s",
               format_table(result, colours, wrap_width(stream)).c_str());
}

void estimate(const EstimateArguments& arguments) {
  const rig_file::RigModel model = rig_file::read_rig_file(arguments.rig);
  rig_file::require_unknowns(model);
  std::vector<Record> records;
  for (const std::string& path : arguments.data) records.push_back(read_record(path, model));
  ResultTarget json(arguments.json), log(arguments.log);
  std::FILE* const people = human_stream(json, log);

  EstimationOptions options;
  if (arguments.frequency_Hz > 0.0) options.excitation_Hz = arguments.frequency_Hz;
  Estimation estimation;
  {
    ProgressBar bar("estimating");
    options.progress = [&bar](double share) { bar.show(share); };
    estimation = estimate_records(model, records, options);
  }
  print_table(people, model, estimation.result);
  json.deliver(to_text(to_json(estimation.result)));
  log.deliver(estimation.frames);
  const std::string missing = unanswered(estimation.result);
  if (!missing.empty()) throw CannotAnswer(missing);
}

}  // namespace

void add_estimate_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("estimate", "Estimate the unknown coefficients of a rig from measured data");
  auto arguments = std::make_shared<EstimateArguments>();
  command->add_option("--rig", arguments->rig, "rig file (TOML); coefficients written \"estimate\" are estimated")
      ->required();
  command->add_option("--data", arguments->data, "measured data; each file is one excitation level; may be repeated")
      ->required();
  command->add_option("--json", arguments->json, "write the result as JSON to this file (- is stdout)");
  command->add_option("--log", arguments->log,
                      "write the CAN frames that a board would send as a candump log (- is stdout)");
  command
      ->add_option("--frequency", arguments->frequency_Hz,
                   "excitation frequency in Hz, where it is periodic: windows are then whole cycles")
      ->check(CLI::PositiveNumber);
  command->footer(
      "Example: host_sim estimate --rig rig.toml --data low_level.csv --data high_level.csv --json result.json");
  command->callback([arguments, &chosen] { chosen = [arguments] { estimate(*arguments); }; });
}

}  // namespace host_sim
