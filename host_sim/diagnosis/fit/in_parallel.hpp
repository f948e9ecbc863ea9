// Pieces of work that do not know of each other, on the machine's cores.
#pragma once
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace diagnosis::runs {

// As many pieces are worked on at a time, each in a lane of its own; beyond eight, what is done in order between them decides.
inline size_t lanes() {
  constexpr unsigned kMost = 8;
  static const size_t count = std::clamp(std::thread::hardware_concurrency(), 1u, kMost);
  return count;
}

// Whether this thread works on one of several pieces: what those share out among themselves is done one after another.
inline thread_local bool on_a_piece = false;

// work(piece, lane) for every piece below count; lane < lanes(), one piece at a time in each. Which lane a piece gets is chance:
// what it gives must not depend on it. The first error that is thrown is thrown here, when all have ended.
template <typename Work>
void in_parallel(size_t count, const Work& work) {
  const size_t at_once = on_a_piece ? 1 : std::min(lanes(), count);
  std::atomic<size_t> next{0};
  std::exception_ptr error;
  std::mutex guard;
  const auto run = [&](size_t lane) {
    const bool outer = std::exchange(on_a_piece, on_a_piece || at_once > 1);
    try {
      for (size_t piece = next++; piece < count; piece = next++) work(piece, lane);
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(guard);
      if (!error) error = std::current_exception();
    }
    on_a_piece = outer;
  };
  std::vector<std::thread> others;
  for (size_t lane = 1; lane < at_once; ++lane) others.emplace_back(run, lane);
  run(0);
  for (std::thread& other : others) other.join();
  if (error) std::rethrow_exception(error);
}

}  // namespace diagnosis::runs
