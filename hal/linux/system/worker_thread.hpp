// A thread for long calculations: above ordinary processes, below everything else that is real-time. Nothing is
// allocated after open().
#pragma once
#include <pthread.h>
#include <semaphore.h>

#include <atomic>
#include <string>

#include "hal/interface/worker.hpp"

namespace hal {

class WorkerThread final : public Worker {
 public:
  WorkerThread() = default;
  ~WorkerThread();
  WorkerThread(const WorkerThread&) = delete;
  WorkerThread& operator=(const WorkerThread&) = delete;

  // real_time: take the lowest SCHED_FIFO priority, where allowed. Empty where it worked, else what is wrong.
  std::string open(bool real_time);

  void start(void (*work)(void*), void* argument) override;
  bool done() override { return done_.load(std::memory_order_acquire); }
  void wait() override;

 private:
  static void* run(void* self);

  pthread_t thread_{};
  sem_t asked_{}, ended_{};
  bool running_ = false;
  std::atomic<bool> done_{true};
  void (*work_)(void*) = nullptr;  // nullptr: end the thread
  void* argument_ = nullptr;
};

}  // namespace hal
