// host_sim estimate: measured data through the fixed-point core, as the board would.
#include <fmt/format.h>

#include <future>
#include <utility>

#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/data_check/channel/hum_weight.hpp"
#include "host_sim/data_check/decay/release.hpp"
#include "host_sim/data_check/drive/one_sign.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/estimate/by_record.hpp"
#include "host_sim/programs/estimate/drive_frequency.hpp"
#include "host_sim/programs/estimate/estimate_report_data.hpp"
#include "host_sim/programs/estimate/model_export.hpp"
#include "host_sim/programs/estimate/prepared_estimation.hpp"
#include "host_sim/programs/estimate/swing_of_rate.hpp"
#include "host_sim/programs/results/result_json.hpp"
#include "host_sim/programs/results/result_table.hpp"
#include "host_sim/programs/shared/above_nought.hpp"
#include "host_sim/programs/shared/data_options.hpp"
#include "host_sim/programs/shared/human_output.hpp"
#include "host_sim/programs/shared/inputs.hpp"
#include "host_sim/programs/shared/one_heap.hpp"
#include "host_sim/programs/shared/shared_records.hpp"
#include "host_sim/programs/shared/terminal.hpp"
#include "host_sim/programs/shared/turned_force.hpp"
#include "host_sim/records/record_checks.hpp"
#include "host_sim/reports/page/report.hpp"

namespace host_sim {
namespace {

struct EstimateArguments {
  std::string rig;
  std::vector<std::string> data;
  std::string json, log, report, export_to;
  double frequency_Hz = 0.0;
  DataArguments reading;
};

void print_table(std::FILE* stream, const rig_file::RigModel& model, const EstimateResult& result) {
  const bool colours = is_terminal(stream);
  std::string head = fmt::format("\n{} samples at {:g} Hz, {} record{}\n\n", result.samples, result.sample_rate_Hz,
                                 result.levels, result.levels == 1 ? "" : "s");
  write_text(stream, model.name + head + format_table(result, colours, wrap_width(stream)));
}

// Page and files for other programs, where they are wanted.
void show_more(const EstimateArguments& arguments, const rig_file::RigModel& model, const std::vector<Record>& records,
               const Estimation& estimation, const data_check::Report& check, std::FILE* people) {
  if (arguments.report.empty() && arguments.export_to.empty()) return;
  const EstimateResult& result = estimation.result;
  reports::EstimateReportData data = estimate_report_data(model, records, result, estimation.simulated);
  data.check = check;
  if (!arguments.report.empty()) {
    reports::write_estimate_report(arguments.report, data);
    std::fprintf(people, "report: %s/index.html\n", arguments.report.c_str());
  }
  if (!arguments.export_to.empty()) {
    export_model(arguments.export_to, model, result, estimated_modes(model, result), data.views);
    std::fprintf(people, "exported: %s/model.json, model.mat, responses as CSV\n", arguments.export_to.c_str());
  }
}

// The check of the data beside the estimation where the records are short enough to be kept twice, should the estimation change them
// (it counts them from their position of rest); before it where they are long.
class DataCheck {
 public:
  DataCheck(const SharedRecords& records, const rig_file::RigModel& model, const DataArguments& arguments)
      : arguments_(arguments) {
    size_t values = 0;
    for (const Record& record : records.get()) values += record.samples() * record.channels.size();
    if (values > kKeptTwice)
      report_ = require_sound(records.get(), model, arguments);
    else
      running_ = std::async(std::launch::async,
                            [kept = records.as_they_are(), &model] { return data_check::check(*kept, &model); });
  }
  // Throws CannotAnswer where the data have faults.
  const data_check::Report& require() {
    if (running_.valid()) require_sound(report_ = running_.get(), arguments_);
    return report_;
  }
  // What goes wrong meanwhile goes wrong because of the data's faults, where they have some.
  template <typename Work>
  void beside(Work work) {
    try {
      work();
    } catch (...) {
      require();
      throw;
    }
    require();
  }

 private:
  static constexpr size_t kKeptTwice = size_t{1} << 25;  // 256 MB: ten channels of 50 minutes at 1 kHz
  const DataArguments& arguments_;
  data_check::Report report_;
  std::future<data_check::Report> running_;
};

void estimate(const EstimateArguments& arguments) {
  use_one_heap();
  rig_file::RigModel model = read_rig(arguments.rig);
  rig_file::require_unknowns(model);
  reports::require_place(arguments.report);
  std::vector<Record> read = read_data(arguments.data, model, arguments.reading);
  require_same_channels(read);
  ResultTarget json(arguments.json), log(arguments.log);
  std::FILE* const people = human_stream(json, log);
  std::vector<std::string> notes = data_check::keep_decays(read);
  SharedRecords records(std::move(read));
  DataCheck check(records, model, arguments.reading);

  EstimationOptions options;
  options.frames = !arguments.log.empty();
  if (arguments.frequency_Hz > 0.0) {
    options.excitation_Hz = arguments.frequency_Hz;
    for (std::string& note : doubt_frequency(records.get(), arguments.frequency_Hz)) notes.push_back(std::move(note));
  }
  Estimation estimation;
  const auto watched = [&](const auto& work) {
    ProgressBar bar("estimating");
    options.progress = [&bar](double share) { bar.show(share); };
    estimation = work();
  };
  const auto estimate_all = [&] { watched([&] { return estimate_records(model, records.get(), options); }); };
  check.beside([&] { watched([&] { return estimate_prepared(model, records, options, notes); }); });
  if (!arguments.reading.in_spite_of_faults && data_check::turn_over(check.require(), records.own())) estimate_all();
  if (may_be_turned(model, records.get()) && says_turned(estimation.result)) {
    notes.push_back(turn_forces(records.own()));
    estimate_all();
  }
  const std::vector<std::string> bent = doubt_bent_gravity(model, records.get(), estimation.result.parameters);
  notes.insert(notes.end(), bent.begin(), bent.end());
  doubt_what_records_contradict(model, records.get(), estimation.result);
  estimation.result.notes.insert(estimation.result.notes.end(), notes.begin(), notes.end());
  estimation.result.hum_in = data_check::spoilt_by_hum(check.require());
  print_table(people, model, estimation.result);
  json.deliver(to_text(to_json(estimation.result)));
  log.deliver(estimation.frames);
  show_more(arguments, model, records.get(), estimation, check.require(), people);
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
  command->add_option("--report", arguments->report, "write a page with pictures to this folder");
  command->add_option("--export", arguments->export_to,
                      "write parameters with covariance, modes and state space as JSON and MAT, and the responses as "
                      "CSV, to this folder");
  command
      ->add_option("--frequency", arguments->frequency_Hz,
                   "excitation frequency in Hz, where it is periodic: windows are then whole cycles")
      ->check(above_nought());
  add_data_options(*command, arguments->reading);
  add_anyway_option(*command, arguments->reading);
  command->footer(
      "Example: host_sim estimate --rig rig.toml --data low_level.csv --data high_level.csv --json result.json");
  command->callback([arguments, &chosen] { chosen = [arguments] { estimate(*arguments); }; });
}

}  // namespace host_sim
