#include "hal/linux/system/worker_thread.hpp"

#include <errno.h>
#include <sched.h>
#include <signal.h>

#include <cstring>

namespace hal {
namespace {

constexpr size_t kStackBytes = 512 * 1024;

void take(sem_t& semaphore) {
  while (sem_wait(&semaphore) != 0 && errno == EINTR) {
  }
}

}  // namespace

std::string WorkerThread::open(bool real_time) {
  sem_init(&asked_, 0, 0);
  sem_init(&ended_, 0, 0);
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStackBytes);
  // The signals that end the program are for the main thread.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const int error = pthread_create(&thread_, &attributes, &WorkerThread::run, this);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  pthread_attr_destroy(&attributes);
  if (error != 0) return std::string("no thread for the estimates: ") + std::strerror(error);
  running_ = true;
  sched_param parameter{};
  parameter.sched_priority = sched_get_priority_min(SCHED_FIFO);
  if (real_time) pthread_setschedparam(thread_, SCHED_FIFO, &parameter);  // refused: it stays an ordinary thread
  return "";
}

WorkerThread::~WorkerThread() {
  if (!running_) return;
  if (!done()) wait();
  start(nullptr, nullptr);
  pthread_join(thread_, nullptr);
  sem_destroy(&asked_);
  sem_destroy(&ended_);
}

void WorkerThread::start(void (*work)(void*), void* argument) {
  work_ = work;
  argument_ = argument;
  done_.store(false, std::memory_order_relaxed);
  sem_post(&asked_);
}

// Each end posts once; the posts of ends that nobody waited for are taken here too.
void WorkerThread::wait() {
  while (!done()) take(ended_);
}

void* WorkerThread::run(void* self) {
  auto& own = *static_cast<WorkerThread*>(self);
  for (;;) {
    take(own.asked_);
    if (own.work_ == nullptr) return nullptr;
    own.work_(own.argument_);
    own.done_.store(true, std::memory_order_release);
    sem_post(&own.ended_);
  }
}

}  // namespace hal
