// What is being done and for how long, on one line of stderr: for work whose end nobody knows beforehand. Silent where
// stderr is no terminal.
#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace host_sim {

class StageLine {
 public:
  explicit StageLine(std::string label);
  ~StageLine();  // erases the line
  StageLine(const StageLine&) = delete;
  StageLine& operator=(const StageLine&) = delete;
  void begin(const std::string& stage);  // "searching for causes"

 private:
  void keep_time();
  void show();

  const std::string label_;
  const bool on_;
  const std::chrono::steady_clock::time_point start_;
  std::mutex mutex_;  // of stage_ and done_
  std::condition_variable wake_;
  std::string stage_;
  bool done_ = false;
  std::thread clock_;
};

}  // namespace host_sim
