// A sweep over machines: mpirun (or srun) starts the same command on each of them and tells it its rank. The ranks share the work
// without talking to each other; each leaves its part beside the result file, and rank 0 joins the parts. So the folder
// of the result file must be one that all machines see.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host_sim/programs/sweep/sweep_runs.hpp"

namespace host_sim {

struct Rank {
  unsigned number = 0, count = 1;  // this process among all
  unsigned on_this_machine = 1;    // processes that share this machine's cores
  std::string job;                 // the same for all ranks of one start
};

// From the environment that Open MPI, MPICH or Slurm set; one rank where none of them started us, as within an allocation of Slurm
// without srun.
Rank rank_from_environment();

// Every count-th task, from number on.
std::vector<SweepTask> share_of(const std::vector<SweepTask>& tasks, const Rank& rank);

// Rank > 0: leaves the runs beside the result file. Returns nothing.
// Rank 0: waits for the others' parts and returns all runs in the order of the tasks; the parts are removed.
std::vector<nlohmann::ordered_json> join_ranks(const Rank& rank, const std::string& result_path,
                                               std::vector<nlohmann::ordered_json> runs);

}  // namespace host_sim
