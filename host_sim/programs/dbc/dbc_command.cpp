// host_sim dbc: every frame for CAN tools.
#include <iostream>

#include "hal/rig_file/compile_rig.hpp"
#include "host_sim/can_log/dbc.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/shared/inputs.hpp"

namespace host_sim {
namespace {

void print_dbc(const std::string& rig) {
  std::vector<can_log::DbcParameter> parameters;
  if (!rig.empty())
    for (const rig_file::ParameterInfo& info : rig_file::parameter_table(read_rig(rig)))
      parameters.push_back({info.name, info.unit});
  can_log::dbc(std::cout, parameters);
}

}  // namespace

void add_dbc_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("dbc", "Print the DBC of every frame");
  auto rig = std::make_shared<std::string>();
  command->add_option("--rig", *rig,
                      "name the estimates after the unknowns of this rig file, and declare them as floats in SI units");
  command->footer("Example: host_sim dbc > rig.dbc");
  command->callback([rig, &chosen] { chosen = [rig] { print_dbc(*rig); }; });
}

}  // namespace host_sim
