// host_sim check: what is wrong with a recording before anybody computes with it.
#include <fmt/format.h>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/report/to_json.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/results/result_json.hpp"
#include "host_sim/programs/shared/data_options.hpp"
#include "host_sim/programs/shared/human_output.hpp"
#include "host_sim/programs/shared/inputs.hpp"
#include "host_sim/programs/shared/one_heap.hpp"
#include "host_sim/programs/shared/terminal.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

struct CheckArguments {
  std::string rig, json;
  std::vector<std::string> data;
  DataArguments reading;
};

std::string channel_line(const data_check::ChannelReport& channel) {
  return fmt::format("  {:<28} {:12.5g} {:12.5g} {:12.3g} {:12.3g}\n", channel.name, channel.rms, channel.mean,
                     channel.noise_floor, channel.resolution);
}

std::string text_of(const data_check::Report& report, bool colours) {
  std::string text;
  for (const data_check::RecordReport& record : report.records) {
    std::string line =
        fmt::format("{}: {} samples at {:.6g} Hz\n  {:<28} {:>12} {:>12} {:>12} {:>12}\n", record.file, record.samples,
                    record.sample_rate_Hz, "channel", "rms", "mean", "noise", "resolution");
    text += line;
    for (const data_check::ChannelReport& channel : record.channels) text += channel_line(channel);
  }
  text += "\n";
  for (const std::string& line : data_check::lines_of(report, data_check::Weight::kInforms)) text += line + "\n";
  const std::string verdict = report.verdict();
  const Colour colour = verdict == "good" ? Colour::kGood : verdict == "usable" ? Colour::kDoubtful : Colour::kBad;
  return text + "verdict: " + coloured(verdict, colour, colours) + "\n";
}

void check(const CheckArguments& arguments) {
  use_one_heap();
  rig_file::RigModel model;
  if (!arguments.rig.empty()) model = read_rig(arguments.rig);
  ResultTarget json(arguments.json);
  std::FILE* const people = json.to_stdout() ? stderr : stdout;
  const std::vector<Record> records = read_data(arguments.data, model, arguments.reading);
  const data_check::Report report = data_check::check(records, arguments.rig.empty() ? nullptr : &model);
  write_text(people, text_of(report, is_terminal(people)));
  json.deliver(to_text(data_check::to_json(report)));
  if (report.worst() == data_check::Weight::kFault)
    throw CannotAnswer("the recordings have faults:\n  " +
                       joined_lines(data_check::lines_of(report, data_check::Weight::kFault)));
}

}  // namespace

void add_check_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("check", "Say what is wrong with a recording before anybody computes with it");
  auto arguments = std::make_shared<CheckArguments>();
  command->add_option("--data", arguments->data, "measured data; may be repeated")->required();
  command->add_option("--rig", arguments->rig,
                      "rig file (TOML): its masses and springs tell more about signs and units");
  command->add_option("--json", arguments->json, "write the result as JSON to this file (- is stdout)");
  add_data_options(*command, arguments->reading);
  command->footer("Example: host_sim check --rig rig.toml --data low_level.csv --data high_level.csv");
  command->callback([arguments, &chosen] { chosen = [arguments] { check(*arguments); }; });
}

}  // namespace host_sim
