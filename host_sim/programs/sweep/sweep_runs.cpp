#include "host_sim/programs/sweep/sweep_runs.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <stdexcept>

#include "host_sim/programs/results/result_json.hpp"
#include "host_sim/programs/run/run_result.hpp"
#include "host_sim/programs/shared/failures.hpp"

namespace host_sim {
namespace {

using nlohmann::ordered_json;

// A child process with the reading end of its pipe; each line is one result, {"index": i, "run": {...}} or {"error":
// text}.
struct Worker {
  pid_t process = -1;
  int pipe = -1;
  std::string unread;
};

void write_line(int descriptor, const ordered_json& json) {
  const std::string line = json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
  for (size_t sent = 0; sent < line.size();) {
    const ssize_t count = ::write(descriptor, line.data() + sent, line.size() - sent);
    if (count <= 0) ::_exit(1);
    sent += static_cast<size_t>(count);
  }
}

// Tasks number, number + stride, ...: neighbours are alike, so all workers have about the same to do.
[[noreturn]] void work(const std::vector<SweepTask>& tasks, size_t number, size_t stride, int descriptor) {
  try {
    for (size_t i = number; i < tasks.size(); i += stride)
      write_line(descriptor, {{"index", i}, {"run", sweep_run(tasks[i])}});
  } catch (const std::exception& error) {
    write_line(descriptor, {{"error", error.what()}});
    ::_exit(1);
  }
  ::_exit(0);
}

Worker start_worker(const std::vector<SweepTask>& tasks, size_t number, size_t stride) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe for a worker process");
  const pid_t process = ::fork();
  if (process < 0) {
    for (const int end : ends) ::close(end);
    throw std::runtime_error("no worker process can be started");
  }
  if (process == 0) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE})
      std::signal(signal, SIG_DFL);  // the parent cleans up
    ::close(ends[0]);
    work(tasks, number, stride, ends[1]);
  }
  ::close(ends[1]);
  return Worker{process, ends[0], ""};
}

class Team {
 public:
  explicit Team(size_t tasks) : results_(tasks) {}
  // Where one cannot be started, those before it are ended with the team.
  void start(const std::vector<SweepTask>& tasks, unsigned workers) {
    for (unsigned i = 0; i < workers; ++i) workers_.push_back(start_worker(tasks, i, workers));
  }
  ~Team() {
    for (const Worker& worker : workers_) {
      if (worker.pipe >= 0) {
        ::kill(worker.process, SIGTERM);  // its results are not wanted any more
        ::close(worker.pipe);
      }
      ::waitpid(worker.process, nullptr, 0);
    }
  }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  std::vector<ordered_json> collect(const std::function<void(size_t)>& done) {
    while (wait_for_input()) done(finished_);
    if (finished_ != results_.size()) throw std::runtime_error("a worker process ended before its work was done");
    return std::move(results_);
  }

 private:
  // False where all workers have closed their pipes.
  bool wait_for_input() {
    std::vector<pollfd> polled;
    std::vector<Worker*> open;
    for (Worker& worker : workers_)
      if (worker.pipe >= 0) {
        polled.push_back({worker.pipe, POLLIN, 0});
        open.push_back(&worker);
      }
    if (open.empty()) return false;
    if (::poll(polled.data(), polled.size(), -1) < 0) return true;
    for (size_t i = 0; i < polled.size(); ++i)
      if (polled[i].revents != 0) read_from(*open[i]);
    return true;
  }

  void read_from(Worker& worker) {
    char chunk[1 << 16];
    const ssize_t count = ::read(worker.pipe, chunk, sizeof chunk);
    if (count <= 0) {
      ::close(worker.pipe);
      worker.pipe = -1;
      return;
    }
    worker.unread.append(chunk, static_cast<size_t>(count));
    for (size_t end = 0; (end = worker.unread.find('\n')) != std::string::npos; worker.unread.erase(0, end + 1))
      take(ordered_json::parse(worker.unread.substr(0, end)));
  }

  void take(const ordered_json& line) {
    if (line.contains("error")) throw UsageError(line["error"].get<std::string>());
    results_.at(line["index"].get<size_t>()) = line["run"];
    ++finished_;
  }

  std::vector<Worker> workers_;
  std::vector<ordered_json> results_;
  size_t finished_ = 0;
};

}  // namespace

std::vector<SweepTask> sweep_tasks(const std::vector<std::string>& scenarios, uint64_t first_seed, uint64_t last_seed) {
  std::vector<SweepTask> tasks;
  for (const std::string& scenario : scenarios)
    for (uint64_t seed = first_seed; seed <= last_seed; ++seed) tasks.push_back({scenario, seed});
  return tasks;
}

ordered_json sweep_run(const SweepTask& task) {
  const Scenario scenario = load_scenario(task.scenario);
  ProgressSink silent;
  const EstimateResult result = result_of_run(scenario, run_scenario(scenario, task.seed, silent));
  const ordered_json whole = to_json(result);
  ordered_json run = {{"scenario", scenario.name}, {"seed", task.seed}};
  for (const char* key : {"parameters", "residual_mean_abs", "condition_number", "mse_percent"}) run[key] = whole[key];
  return run;
}

std::vector<ordered_json> run_in_parallel(const std::vector<SweepTask>& tasks, unsigned workers,
                                          const std::function<void(size_t)>& done) {
  const auto useful = static_cast<unsigned>(std::min<size_t>(std::max(1u, workers), std::max<size_t>(1, tasks.size())));
  Team team(tasks.size());
  team.start(tasks, useful);
  return team.collect(done);
}

}  // namespace host_sim
