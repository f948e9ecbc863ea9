// Samples that come at another rate than the configuration says: nothing in their codes tells, their times do.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/rig_controller/bench.hpp"

namespace {

using firmware::EstimateStatus;

// The bench's rig as it moves at 20 Hz in the long run, a millimetre, in its units.
firmware::RawSample moving(uint32_t sequence) {
  const double w = 2.0 * M_PI * 20.0, t = sequence / 1000.0;
  const double x = 1e-3 * std::sin(w * t), v = 1e-3 * w * std::cos(w * t), a = -w * w * x;
  firmware::RawSample sample;
  sample.sequence = sequence;
  sample.code[0][0] = static_cast<int32_t>(std::lround((a + 20.0 * v + 1e4 * x) / 1e-4));
  sample.code[0][1] = static_cast<int32_t>(std::lround(x / 1e-8));
  sample.code[0][2] = static_cast<int32_t>(std::lround(v / 1e-6));
  sample.code[0][3] = static_cast<int32_t>(std::lround(a / 1e-4));
  return sample;
}

// Three seconds of it, as the file has it, that come each `period_ns`, or so many together, stamped when they are fetched.
EstimateStatus status_at(uint64_t period_ns, uint64_t burst = 1) {
  bench::Bench bench(bench::listening());
  bench.step();
  const uint64_t begin_ns = bench.clock.now_ns();
  for (uint32_t n = 0; n < 3000; ++n) {
    firmware::RawSample sample = moving(n);
    sample.time_ns = begin_ns + (n / burst + 1) * burst * period_ns;
    bench.clock.set_ns(sample.time_ns);
    bench.source.offer(sample);
    bench.step();
  }
  EXPECT_NE(bench.controller->estimates(), nullptr);
  return bench.controller->estimates()->parameters[0].status;
}

TEST(SampleRate, AnotherRateThanTheFilesIsNotBelieved) {
  const EstimateStatus usual = status_at(bench::kMillisecond_ns);
  EXPECT_NE(usual, EstimateStatus::kStale);
  EXPECT_NE(usual, EstimateStatus::kSkewed);
  EXPECT_EQ(status_at(2 * bench::kMillisecond_ns), EstimateStatus::kSkewed);
  EXPECT_EQ(status_at(bench::kMillisecond_ns / 2), EstimateStatus::kSkewed);
  EXPECT_EQ(status_at(1024 * bench::kMillisecond_ns / 1000), usual);  // a clock is within some percent
  EXPECT_EQ(status_at(bench::kMillisecond_ns, 64), usual);            // buffered
}

// A counter that begins anew, and samples that nobody stamps.
TEST(SampleRate, IsCountedFromWhatHasATime) {
  const firmware::Scaled period_s = firmware::Scaled::ratio(1, 1000);
  firmware::SampleClock clock;
  const auto take = [&](uint32_t sequence, uint64_t time_ms) {
    firmware::RawSample sample;
    sample.sequence = sequence;
    sample.time_ns = time_ms * bench::kMillisecond_ns;
    clock.take(sample);
  };
  EXPECT_FALSE(clock.off_rate(period_s));
  take(5000, 0);
  EXPECT_FALSE(clock.off_rate(period_s));
  take(4294967295u, 10000);
  take(999, 11000);  // over the end of 32 bits
  EXPECT_FALSE(clock.off_rate(period_s));
  take(1999, 13000);
  EXPECT_TRUE(clock.off_rate(period_s));
  take(4294960000u, 13100);  // before the first: anew
  EXPECT_FALSE(clock.off_rate(period_s));
  take(4294961000u, 14100);
  EXPECT_FALSE(clock.off_rate(period_s));
  clock.begin_level();
  EXPECT_FALSE(clock.off_rate(period_s));
}

}  // namespace
