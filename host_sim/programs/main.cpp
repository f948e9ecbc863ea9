// host_sim: simulate a rig, estimate from measured data, name what a model lacks, read the frames.
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/failures.hpp"
#include "host_sim/records/output_file.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Damping of vibration rigs: simulate, estimate, diagnose, read CAN frames", "host_sim"};
  app.require_subcommand(1);
  host_sim::remove_temporary_files_on_signals();
  host_sim::Action chosen;
  host_sim::add_estimate_command(app, chosen);
  host_sim::add_decode_command(app, chosen);
  host_sim::add_dbc_command(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked_for_help = app.exit(error) == 0;
    return static_cast<int>(asked_for_help ? host_sim::ExitStatus::kDone : host_sim::ExitStatus::kBadInput);
  }
  return host_sim::guarded(chosen);
}
