// The thread for long calculations: each work once, its writes seen, the starter not held up.
#include "hal/linux/system/worker_thread.hpp"

#include <gtest/gtest.h>
#include <semaphore.h>
#include <signal.h>

namespace {

struct Gate {
  Gate() { sem_init(&open, 0, 0); }
  sem_t open;
  int passed = 0;
  bool end_signal_blocked = false;
  static void pass(void* self) {
    auto& gate = *static_cast<Gate*>(self);
    sigset_t blocked;
    pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
    gate.end_signal_blocked = sigismember(&blocked, SIGTERM) == 1;
    while (sem_wait(&gate.open) != 0) {
    }
    ++gate.passed;
  }
};

TEST(WorkerThread, WorksBesideItsStarter) {
  hal::WorkerThread worker;
  ASSERT_EQ(worker.open(false), "");
  EXPECT_TRUE(worker.done());
  worker.wait();  // nothing to wait for
  Gate gate;
  worker.start(&Gate::pass, &gate);
  EXPECT_FALSE(worker.done());  // it cannot be: the gate is closed
  sem_post(&gate.open);
  worker.wait();
  EXPECT_TRUE(worker.done());
  EXPECT_EQ(gate.passed, 1);
  EXPECT_TRUE(gate.end_signal_blocked);
}

TEST(WorkerThread, AThousandWorksInARowSomeWaitedFor) {
  hal::WorkerThread worker;
  ASSERT_EQ(worker.open(true), "");
  int sum = 0;
  for (int i = 0; i < 1000; ++i) {
    if (i % 3 == 0) {
      worker.wait();
    } else {
      while (!worker.done()) {
      }
    }
    worker.start([](void* number) { ++*static_cast<int*>(number); }, &sum);
  }
  worker.wait();
  EXPECT_EQ(sum, 1000);
}

TEST(WorkerThread, EndsAfterItsWork) {
  Gate gate;
  sem_post(&gate.open);
  {
    hal::WorkerThread worker;
    ASSERT_EQ(worker.open(false), "");
    worker.start(&Gate::pass, &gate);
  }
  EXPECT_EQ(gate.passed, 1);
  { hal::WorkerThread never_opened; }
}

}  // namespace
