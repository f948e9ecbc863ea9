// host_sim decode: what the frames on the bus mean.
#include <fstream>
#include <iostream>

#include "host_sim/can_log/decode.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/shared/failures.hpp"

namespace host_sim {
namespace {

void decode(const std::string& path, can_log::DecodeOptions options) {
  if (path.empty() || path == "-") {
    can_log::decode(std::cin, std::cout, std::cerr, options);
    return;
  }
  std::ifstream file(path);
  if (!file || file.peek() == std::ifstream::traits_type::eof())
    throw UsageError(path + ": cannot be read or is empty, expected a candump log");
  can_log::decode(file, std::cout, std::cerr, options);
}

}  // namespace

void add_decode_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("decode", "Turn candump text into one readable line per signal");
  auto path = std::make_shared<std::string>();
  command->add_option("FILE", *path, "output of candump or candump -L; without it: standard input");
  auto options = std::make_shared<can_log::DecodeOptions>();
  command->add_flag("--changes", options->changes_only, "leave out signals that say the same as before");
  command->footer("Example: candump can0 | host_sim decode");
  command->callback([path, options, &chosen] { chosen = [path, options] { decode(*path, *options); }; });
}

}  // namespace host_sim
