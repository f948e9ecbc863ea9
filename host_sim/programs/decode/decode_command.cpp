// host_sim decode: what the frames on the bus mean.
#include <fstream>
#include <iostream>

#include "host_sim/can_log/decode.hpp"
#include "host_sim/can_log/follow_buffer.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/shared/failures.hpp"

namespace host_sim {
namespace {

struct DecodeSettings {
  std::string path;
  bool csv = false, json = false, follow = false;
  can_log::DecodeOptions options;
};

bool reads_stdin(const DecodeSettings& settings) { return settings.path.empty() || settings.path == "-"; }

can_log::DecodeSummary decode_file(const DecodeSettings& settings, const can_log::DecodeOptions& options) {
  if (settings.follow) {
    can_log::FollowBuffer buffer(settings.path);
    if (!buffer.is_open()) throw UsageError(settings.path + ": cannot be read, expected a candump log");
    std::istream stream(&buffer);
    return can_log::decode(stream, std::cout, std::cerr, options);
  }
  std::ifstream file(settings.path);
  if (!file || file.peek() == std::ifstream::traits_type::eof())
    throw UsageError(settings.path + ": cannot be read or is empty, expected a candump log");
  return can_log::decode(file, std::cout, std::cerr, options);
}

void decode(const DecodeSettings& settings) {
  if (settings.follow && reads_stdin(settings)) throw UsageError("--follow: expected a FILE beside it");
  can_log::DecodeOptions options = settings.options;
  if (settings.csv) options.format = can_log::DecodeFormat::kCsv;
  if (settings.json) options.format = can_log::DecodeFormat::kJson;
  const can_log::DecodeSummary summary =
      reads_stdin(settings) ? can_log::decode(std::cin, std::cout, std::cerr, options) : decode_file(settings, options);
  if (summary.frames == 0)
    throw CannotAnswer((reads_stdin(settings) ? "standard input" : settings.path) +
                       ": no CAN frame in it, expected what candump or candump -L prints");
}

}  // namespace

void add_decode_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("decode", "Turn candump text into one readable line per signal");
  auto settings = std::make_shared<DecodeSettings>();
  command->add_option("FILE", settings->path, "output of candump or candump -L; without it: standard input");
  command->add_flag("--changes", settings->options.changes_only, "leave out signals that say the same as before");
  CLI::Option* csv =
      command->add_flag("--csv", settings->csv, "comma-separated rows with a head, for awk and databases");
  command->add_flag("--json", settings->json, "one JSON object a line, the same columns")->excludes(csv);
  command->add_flag("--follow", settings->follow, "wait at the end of FILE for more, until interrupted");
  command->footer("Example: candump can0 | host_sim decode");
  command->callback([settings, &chosen] { chosen = [settings] { decode(*settings); }; });
}

}  // namespace host_sim
