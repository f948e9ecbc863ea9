// The subcommands of host_sim. Each add_ function declares its options; when the command line chooses it, `chosen` is
// set to what is to be done.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace host_sim {

using Action = std::function<void()>;

void add_run_command(CLI::App& app, Action& chosen);
void add_estimate_command(CLI::App& app, Action& chosen);
void add_check_command(CLI::App& app, Action& chosen);
void add_diagnose_command(CLI::App& app, Action& chosen);
void add_sweep_command(CLI::App& app, Action& chosen);
void add_decode_command(CLI::App& app, Action& chosen);
void add_dbc_command(CLI::App& app, Action& chosen);
void add_watch_command(CLI::App& app, Action& chosen);

}  // namespace host_sim
