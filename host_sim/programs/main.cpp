// host_sim: simulate a rig, estimate from measured data, name what a model lacks, read the frames.
#include <malloc.h>

#include <cstdio>
#include <memory>

#include "firmware/version.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/shared/failures.hpp"
#include "host_sim/programs/shared/help_text.hpp"
#include "host_sim/programs/shared/human_output.hpp"
#include "host_sim/programs/shared/option_errors.hpp"
#include "host_sim/records/files/output_file.hpp"

namespace {

// CLI11 only says that a subcommand is missing; a misspelt one deserves its name in the message.
bool known_first_word(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return true;
  std::string known;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == argv[1]) return true;
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  std::fprintf(stderr, "host_sim: \"%s\" is no command, expected one of %s\n", argv[1], known.c_str());
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  // Records are vectors of some hundred kilobytes that come and go: memory once taken is kept, not asked for again.
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  CLI::App app{"Damping of vibration rigs: simulate, estimate, diagnose, read CAN frames", "host_sim"};
  app.require_subcommand(1);
  app.formatter(std::make_shared<host_sim::HelpText>());
  app.set_version_flag("--version", std::string("host_sim ") + firmware::kVersionText);
  host_sim::remove_temporary_files_on_signals();
  host_sim::Action chosen;
  host_sim::add_run_command(app, chosen);
  host_sim::add_estimate_command(app, chosen);
  host_sim::add_check_command(app, chosen);
  host_sim::add_diagnose_command(app, chosen);
  host_sim::add_sweep_command(app, chosen);
  host_sim::add_decode_command(app, chosen);
  host_sim::add_watch_command(app, chosen);
  host_sim::add_dbc_command(app, chosen);
  if (!known_first_word(app, argc, argv)) return static_cast<int>(host_sim::ExitStatus::kBadInput);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      std::fprintf(stderr, "host_sim: %s\n", host_sim::option_error_text(app, error).c_str());
      return static_cast<int>(host_sim::ExitStatus::kBadInput);
    }
    app.exit(error);  // help or version
    return host_sim::guarded(host_sim::finish_stdout);
  }
  return host_sim::guarded([&] {
    chosen();
    host_sim::finish_stdout();
  });
}
