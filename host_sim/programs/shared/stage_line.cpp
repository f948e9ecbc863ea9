#include "host_sim/programs/shared/stage_line.hpp"

#include <cstdio>

#include "host_sim/programs/shared/terminal.hpp"

namespace host_sim {

StageLine::StageLine(std::string label)
    : label_(std::move(label)), on_(is_terminal(stderr)), start_(std::chrono::steady_clock::now()) {
  if (on_) clock_ = std::thread([this] { keep_time(); });
}

StageLine::~StageLine() {
  if (!on_) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ = true;
  }
  wake_.notify_one();
  clock_.join();
  std::fprintf(stderr, "\r\033[K");
}

void StageLine::begin(const std::string& stage) {
  if (!on_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  stage_ = stage;
  show();
}

void StageLine::keep_time() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!wake_.wait_for(lock, std::chrono::seconds(1), [this] { return done_; })) show();
}

void StageLine::show() {
  const auto seconds =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - start_).count();
  std::fprintf(stderr, "\r\033[K%s: %s, %lld s", label_.c_str(), stage_.c_str(), static_cast<long long>(seconds));
  std::fflush(stderr);
}

}  // namespace host_sim
