// host_sim diagnose: what the simulation of a rig gets wrong, named, added to the model, and what that gains.
#include <algorithm>
#include <cmath>

#include "hal/rig_file/toml/rig_writer.hpp"
#include "host_sim/data_check/channel/ripple.hpp"
#include "host_sim/data_check/decay/release.hpp"
#include "host_sim/data_check/drive/one_sign.hpp"
#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/diagnosis/sensors/ac_coupling.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/diagnose/diagnosis_text.hpp"
#include "host_sim/programs/diagnose/driven_records.hpp"
#include "host_sim/programs/diagnose/energies_say.hpp"
#include "host_sim/programs/diagnose/without_drift.hpp"
#include "host_sim/programs/results/result_json.hpp"
#include "host_sim/programs/shared/data_options.hpp"
#include "host_sim/programs/shared/failures.hpp"
#include "host_sim/programs/shared/human_output.hpp"
#include "host_sim/programs/shared/inputs.hpp"
#include "host_sim/programs/shared/one_heap.hpp"
#include "host_sim/programs/shared/stage_line.hpp"
#include "host_sim/programs/shared/terminal.hpp"
#include "host_sim/records/derived/computed_anywhere.hpp"
#include "host_sim/records/record_checks.hpp"
#include "host_sim/reports/data/from_diagnosis.hpp"
#include "host_sim/reports/page/report.hpp"
#include "host_sim/reports/sections/verdict.hpp"

namespace host_sim {
namespace {

struct DiagnoseArguments {
  std::string rig;
  std::vector<std::string> data, holdout;
  std::string report, json, extended_rig;
  DataArguments reading;
};

void diagnose(const DiagnoseArguments& arguments) {
  use_one_heap();
  const rig_file::RigModel model = read_rig(arguments.rig);
  reports::require_place(arguments.report);
  ResultTarget json(arguments.json), extended_rig(arguments.extended_rig);
  std::FILE* const people = human_stream(json, extended_rig);
  const diagnosis::Options options;
  diagnosis::Diagnosis found;
  reports::DiagnosisReportData data;
  {
    StageLine line("diagnosing");
    line.begin("reading the recordings");
    require_unseen(arguments.data, arguments.holdout);
    std::vector<Record> training = read_data(arguments.data, model, arguments.reading),
                        holdout = read_data(arguments.holdout, model, arguments.reading);
    for (const LeftOutToo& column : leave_out_computed_anywhere({&training, &holdout}))
      std::fprintf(stderr, "%s: %s\n", column.file.c_str(), column.note.c_str());
    for (std::vector<Record>* records : {&training, &holdout})
      for (const std::string& told : data_check::keep_decays(*records)) std::fprintf(stderr, "%s\n", told.c_str());
    require_same_channels(training);
    if (!holdout.empty()) require_same_channels(training.front(), holdout);
    order_channels_as(training.front(), holdout);
    const data_check::Report check = require_sound(training, model, arguments.reading);
    const data_check::Report holdout_check = require_sound(holdout, model, arguments.reading);
    // a sign is of the cable: what the one tells holds for the other, which may be too short
    data_check::Report all = check;
    all.records.insert(all.records.end(), holdout_check.records.begin(), holdout_check.records.end());
    if (!arguments.reading.in_spite_of_faults)
      data_check::turn_over(all, training), data_check::turn_over(all, holdout);
    if (const std::string told = turn_forces_round(model, training, holdout); !told.empty())
      std::fprintf(stderr, "%s\n", told.c_str());
    for (const std::string& told : count_forced_from_rest(model, training, holdout))
      std::fprintf(stderr, "%s\n", told.c_str());
    line.begin("searching for what the rig file lacks");
    found = diagnosis::diagnose(model, training, holdout, options);
    if (const std::string told = diagnose_without_drift(model, training, holdout, found); !told.empty())
      std::fprintf(stderr, "%s\n", told.c_str());
    ask_energies(training, found);
    for (const std::string& told : data_check::ripples_of(check)) found.advice.push_back(told);
    for (std::vector<Record>* records : {&training, &holdout})
      undo_ac_coupling(diagnosis::couplings_of(found), *records);
    line.begin("simulating what was found");
    data = reports::findings_of(model, training, holdout, found);
    if (!arguments.report.empty()) {
      reports::add_pictures(model, training, holdout, found, data);
      line.begin("drawing");
      data.check = check;
      reports::write_diagnosis_report(arguments.report, data);
    }
  }
  json.deliver(to_text(diagnosis::to_json(found)));
  extended_rig.deliver(rig_file::format_rig(found.extended_rig));
  std::string text = diagnosis_text(data, is_terminal(people), wrap_width(people));
  if (!arguments.report.empty()) text += "report: " + arguments.report + "/index.html\n";
  if (extended_rig.wanted() && !extended_rig.to_stdout())
    text += "extended rig: " + arguments.extended_rig +
            (found.causes.empty() ? " (the rig as given: nothing was named that could be added)\n" : "\n");
  write_text(people, text);
  if (reports::tells_nothing(data))
    throw CannotAnswer("these records determine no coefficient of the rig: record what the advice asks for");
}

}  // namespace

void add_diagnose_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "diagnose", "Show what the simulation of a rig gets wrong, name the cause, extend the model, measure the gain");
  auto arguments = std::make_shared<DiagnoseArguments>();
  command->add_option("--rig", arguments->rig, "rig file (TOML)")->required();
  command->add_option("--data", arguments->data, "measured data; may be repeated")->required();
  command->add_option(
      "--holdout", arguments->holdout,
      "measured data that the fit does not see; may be repeated; default: the last 30 % of each record");
  command->add_option("--report", arguments->report, "write a page with pictures to this folder");
  command->add_option("--json", arguments->json, "write the result as JSON to this file (- is stdout)");
  command->add_option("--extended-rig", arguments->extended_rig,
                      "write the rig with the named effects to this file (- is stdout)");
  add_data_options(*command, arguments->reading);
  add_anyway_option(*command, arguments->reading);
  command->footer("Example: host_sim diagnose --rig rig.toml --data record.csv --report report");
  command->callback([arguments, &chosen] { chosen = [arguments] { diagnose(*arguments); }; });
}

}  // namespace host_sim
