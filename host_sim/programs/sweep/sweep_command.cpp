// host_sim sweep: the same scenarios with many seeds, on all cores and, under mpirun, on many machines.
#include <charconv>
#include <thread>

#include "host_sim/plant/scenario/scenario.hpp"
#include "host_sim/programs/commands.hpp"
#include "host_sim/programs/results/result_json.hpp"
#include "host_sim/programs/shared/above_nought.hpp"
#include "host_sim/programs/shared/human_output.hpp"
#include "host_sim/programs/shared/inputs.hpp"
#include "host_sim/programs/shared/terminal.hpp"
#include "host_sim/programs/sweep/sweep_ranks.hpp"
#include "host_sim/programs/sweep/sweep_summary.hpp"

namespace host_sim {
namespace {

struct SweepArguments {
  std::vector<std::string> scenarios;
  std::string seeds, json;
  unsigned workers = 0;
};

struct SeedRange {
  uint64_t first = 0, last = 0;
};

SeedRange parse_seeds(const std::string& text) {
  constexpr uint64_t kMost = 1000000;
  SeedRange range;
  const char* const end = text.data() + text.size();
  const auto [dots, first_error] = std::from_chars(text.data(), end, range.first);
  const bool dotted = end - dots > 2 && dots[0] == '.' && dots[1] == '.';
  const bool whole = first_error == std::errc() && dotted && std::from_chars(dots + 2, end, range.last).ptr == end;
  if (!whole || range.last < range.first || range.last - range.first >= kMost)
    throw UsageError("--seeds is \"" + text + "\", expected FIRST..LAST such as 1..200, at most a million");
  return range;
}

void sweep(const SweepArguments& arguments) {
  const SeedRange seeds = parse_seeds(arguments.seeds);
  for (const std::string& scenario : arguments.scenarios) read_scenario(scenario);  // a bad one is told before the work
  const Rank rank = rank_from_environment();
  if (rank.count > 1 && (arguments.json.empty() || arguments.json == "-"))
    throw UsageError("--json is missing, expected a result file in a folder that all machines see");
  ResultTarget json(rank.number == 0 ? arguments.json : "");

  const std::vector<SweepTask> tasks = share_of(sweep_tasks(arguments.scenarios, seeds.first, seeds.last), rank);
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency() / rank.on_this_machine);
  std::vector<nlohmann::ordered_json> runs;
  {
    ProgressBar bar("sweeping");
    runs = run_in_parallel(tasks, arguments.workers > 0 ? arguments.workers : cores, [&](size_t done) {
      if (rank.number == 0) bar.show(static_cast<double>(done) / static_cast<double>(tasks.size()));
    });
  }
  runs = join_ranks(rank, arguments.json, std::move(runs));
  if (rank.number > 0) return;
  nlohmann::ordered_json result = {{"schema", "sweep/1"}, {"seeds", {seeds.first, seeds.last}}};
  result["summary"] = summarise(runs);
  result["runs"] = runs;
  json.deliver(to_text(result));
  std::fputs(format_summary(result["summary"]).c_str(), json.to_stdout() ? stderr : stdout);
}

}  // namespace

void add_sweep_command(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("sweep", "Run scenarios with many seeds on all cores (under mpirun: on all machines)");
  auto arguments = std::make_shared<SweepArguments>();
  command->add_option("--scenario", arguments->scenarios, "shipped scenario or scenario file; may be repeated")
      ->required();
  command->add_option("--seeds", arguments->seeds, "FIRST..LAST")->required();
  command->add_option("--json", arguments->json, "write all runs and their summary as JSON to this file (- is stdout)");
  command->add_option("--workers", arguments->workers, "processes on this machine; default: one per core")
      ->check(above_nought());
  command->footer(
      "Examples: host_sim sweep --scenario paper_2dof_noise --seeds 1..200 --json sweep.json\n"
      "          mpirun -np 8 host_sim sweep --scenario paper_2dof_noise --seeds 1..5000 --json /shared/sweep.json");
  command->callback([arguments, &chosen] { chosen = [arguments] { sweep(*arguments); }; });
}

}  // namespace host_sim
