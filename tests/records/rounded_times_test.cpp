// Times that were rounded as they were written.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/records/csv/csv_reader.hpp"

namespace {

TEST(RoundedTimes, AreNoJitter) {
  for (const double rate_Hz : {300.0, 900.0, 1024.0}) {
    std::string text = "t_s,displacement_1_m\n";
    for (int i = 0; i < 600; ++i) text += fmt::format("{:.3f},{}\n", i / rate_Hz, i % 7);
    const host_sim::Record record = host_sim::parse_csv(text, "d.csv", {});
    EXPECT_EQ(record.time_jitter_s, 0.0) << rate_Hz;
    ASSERT_EQ(record.notes.size(), 1u);
    EXPECT_EQ(record.notes[0].rfind("times are rounded to 0.001 s", 0), 0u);
  }
  std::string fine = "t_s,displacement_1_m\n", loose = fine;  // rounded by less than 1 % of a step; not rounded
  for (int i = 0; i < 600; ++i) {
    fine += fmt::format("{:.4f},{}\n", i / 70.0, i % 7);
    loose += fmt::format("{:.9f},{}\n", i / 70.0 + 5e-5 * std::sin(0.7 * i), i % 7);
  }
  EXPECT_EQ(host_sim::parse_csv(fine, "d.csv", {}).time_jitter_s, 0.0);
  EXPECT_NEAR(host_sim::parse_csv(loose, "d.csv", {}).time_jitter_s, 5e-5 / std::sqrt(2.0), 5e-6);
}

}  // namespace
