// host_sim decode and host_sim dbc: what the frames on the bus mean.
#include <fstream>
#include <iostream>

#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/rig_reader.hpp"
#include "host_sim/can_log/dbc.hpp"
#include "host_sim/can_log/decode.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/failures.hpp"

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

void print_dbc(const std::string& rig) {
  std::vector<std::string> names;
  if (!rig.empty()) names = rig_file::parameter_names(rig_file::read_rig_file(rig));
  can_log::dbc(std::cout, names);
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

void add_dbc_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("dbc", "Print the DBC of every frame");
  auto rig = std::make_shared<std::string>();
  command->add_option("--rig", *rig, "name the estimates after the unknowns of this rig file");
  command->footer("Example: host_sim dbc > rig.dbc");
  command->callback([rig, &chosen] { chosen = [rig] { print_dbc(*rig); }; });
}

}  // namespace host_sim
