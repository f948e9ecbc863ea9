// A calculation in slices: what it computes, when it is held, and what is not counted.
#include "hal/bare_metal/sliced_worker.hpp"

#include <gtest/gtest.h>

#include "firmware/fixed_point/scaled.hpp"

namespace {

constexpr size_t kStack = 256 * 1024;
alignas(16) uint8_t stack[kStack];

struct Sum {
  int terms = 0;
  int64_t value = 0;
};

// 1 + 2 + ... + terms, 1000 instructions each.
void add_up(void* argument) {
  auto& sum = *static_cast<Sum*>(argument);
  for (int n = 1; n <= sum.terms; ++n) {
    sum.value += n;
    firmware::report_work(1000);
  }
}

TEST(SlicedWorker, ASliceEndsWithTheReportThatSpendsItsShare) {
  // 3500 instructions a slice: the fourth report (4000) is beyond them. Ten terms: 4 + 4 + 2, and the end.
  hal::SlicedWorker worker(stack, kStack, 3500);
  Sum sum;
  sum.terms = 10;
  worker.start(add_up, &sum);
  EXPECT_EQ(sum.value, 0);  // nothing is done before the first slice
  EXPECT_FALSE(worker.done());
  worker.run_slice();
  EXPECT_EQ(sum.value, 1 + 2 + 3 + 4);
  worker.run_slice();
  EXPECT_EQ(sum.value, 36);  // 1 to 8
  EXPECT_FALSE(worker.done());
  worker.run_slice();
  EXPECT_EQ(sum.value, 55);
  EXPECT_TRUE(worker.done());
  worker.run_slice();  // there is nothing left
  EXPECT_EQ(sum.value, 55);
}

TEST(SlicedWorker, WorksAgainAfterItIsDone) {
  hal::SlicedWorker worker(stack, kStack, 1500);
  for (int terms : {3, 0, 7}) {
    Sum sum;
    sum.terms = terms;
    worker.start(add_up, &sum);
    worker.wait();
    EXPECT_TRUE(worker.done());
    EXPECT_EQ(sum.value, terms * (terms + 1) / 2);
  }
}

TEST(SlicedWorker, WhatRunsBetweenSlicesIsNotHeld) {
  hal::SlicedWorker worker(stack, kStack, 500);
  Sum sum;
  sum.terms = 3;
  worker.start(add_up, &sum);
  worker.run_slice();
  Sum between;  // as a sample's own work would be
  between.terms = 5;
  add_up(&between);
  EXPECT_EQ(between.value, 15);
  EXPECT_EQ(sum.value, 1);
  worker.wait();
  EXPECT_EQ(sum.value, 6);
}

TEST(SlicedWorker, ArithmeticReportsItsWorkAndGivesTheSameNumbers) {
  // 1 / 1 + 1 / 2 + ... + 1 / 40 by Scaled's division: 40 quotients of 800 instructions, held at each.
  struct Harmonic {
    firmware::Scaled sum;
    static void add(void* argument) {
      auto& own = *static_cast<Harmonic*>(argument);
      for (int n = 1; n <= 40; ++n)
        own.sum =
            own.sum + firmware::Scaled::from_int(1) / firmware::Scaled::from_int(n) * firmware::Scaled::from_int(1);
    }
  };
  Harmonic whole, sliced;
  Harmonic::add(&whole);
  hal::SlicedWorker worker(stack, kStack, 400);
  worker.start(Harmonic::add, &sliced);
  int slices = 0;
  for (; !worker.done(); ++slices) worker.run_slice();
  EXPECT_EQ(sliced.sum.mantissa, whole.sum.mantissa);
  EXPECT_EQ(sliced.sum.exponent, whole.sum.exponent);
  EXPECT_GT(slices, 40);
}

}  // namespace
