#include "host_sim/programs/sweep/sweep_ranks.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <thread>

#include "host_sim/records/files/file_content.hpp"
#include "host_sim/records/files/output_file.hpp"

namespace host_sim {
namespace {

using nlohmann::ordered_json;

const char* first_of(std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const char* value = std::getenv(name); value != nullptr && *value != '\0') return value;
  return nullptr;
}

unsigned number_of(std::initializer_list<const char*> names, unsigned otherwise) {
  const char* text = first_of(names);
  return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

std::string part_path(const std::string& result_path, const Rank& rank, unsigned number) {
  return result_path + ".job-" + rank.job + ".rank-" + std::to_string(number);
}

std::vector<ordered_json> take_part(const std::string& path) {
  while (!std::filesystem::exists(path)) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const ordered_json part = ordered_json::parse(read_whole_file(path));
  std::filesystem::remove(path);
  return part.get<std::vector<ordered_json>>();
}

// Slurm tells the tasks of an allocation to its shell and its batch script too, where one process alone is started. srun starts a step.
unsigned slurm_tasks() {
  return first_of({"SLURM_STEP_ID", "SLURM_STEPID"}) == nullptr
             ? 1
             : number_of({"SLURM_STEP_NUM_TASKS", "SLURM_NTASKS"}, 1);
}

}  // namespace

Rank rank_from_environment() {
  Rank rank;
  rank.count = std::max(1u, number_of({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}, slurm_tasks()));
  rank.number = number_of({"OMPI_COMM_WORLD_RANK", "PMI_RANK", "SLURM_PROCID"}, 0);
  if (rank.number >= rank.count) rank = Rank{};
  rank.on_this_machine = std::max(1u, number_of({"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS"}, 1));
  const char* job = first_of({"PMIX_NAMESPACE", "SLURM_JOB_ID", "PMI_JOBID"});
  for (const char* c = job == nullptr ? "0" : job; *c != '\0'; ++c)
    rank.job += std::isalnum(static_cast<unsigned char>(*c)) != 0 ? *c : '_';
  return rank;
}

std::vector<SweepTask> share_of(const std::vector<SweepTask>& tasks, const Rank& rank) {
  std::vector<SweepTask> share;
  for (size_t i = rank.number; i < tasks.size(); i += rank.count) share.push_back(tasks[i]);
  return share;
}

std::vector<ordered_json> join_ranks(const Rank& rank, const std::string& result_path, std::vector<ordered_json> runs) {
  if (rank.count == 1) return runs;
  if (rank.number > 0) {
    write_output_file(part_path(result_path, rank, rank.number),
                      ordered_json(runs).dump(-1, ' ', false, ordered_json::error_handler_t::replace));
    return {};
  }
  std::vector<std::vector<ordered_json>> parts = {std::move(runs)};
  for (unsigned number = 1; number < rank.count; ++number)
    parts.push_back(take_part(part_path(result_path, rank, number)));
  std::vector<ordered_json> all;
  for (size_t row = 0; row < parts.front().size(); ++row)
    for (std::vector<ordered_json>& part : parts)
      if (row < part.size()) all.push_back(std::move(part[row]));
  return all;
}

}  // namespace host_sim
