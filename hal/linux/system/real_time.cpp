#include "hal/linux/system/real_time.hpp"

#include <errno.h>
#include <malloc.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/timerfd.h>

#include <cstring>

namespace hal {
namespace {

// Touches 128 KiB of stack, so that the first deep call later finds its pages there.
void touch_stack() {
  volatile char stack[128 * 1024];
  for (size_t i = 0; i < sizeof stack; i += 1024) stack[i] = 0;
}

}  // namespace

std::string become_real_time(int priority) {
  std::string refused;
  mallopt(M_TRIM_THRESHOLD, -1);  // freed memory stays in the process
  mallopt(M_MMAP_MAX, 0);
  if (::mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    refused = std::string("memory is not locked (") + std::strerror(errno) + ")";
  touch_stack();
  if (priority == 0) return refused;
  sched_param parameter{};
  parameter.sched_priority = priority;
  if (::sched_setscheduler(0, SCHED_FIFO, &parameter) != 0)
    refused += (refused.empty() ? "" : "; ") + std::string("no real-time priority (") + std::strerror(errno) + ")";
  return refused;
}

bool Ticker::start(uint64_t period_ns) {
  timer_ = FileDescriptor(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC));
  itimerspec times{};
  times.it_interval.tv_sec = static_cast<time_t>(period_ns / 1000000000u);
  times.it_interval.tv_nsec = static_cast<long>(period_ns % 1000000000u);
  times.it_value = times.it_interval;
  return timer_ && ::timerfd_settime(timer_.get(), 0, &times, nullptr) == 0;
}

void Ticker::take() {
  uint64_t passed = 0;
  if (::read(timer_.get(), &passed, sizeof passed) != static_cast<ssize_t>(sizeof passed)) return;
  ticks_ += passed;
  missed_ += passed - 1;
}

}  // namespace hal
