#include "host_sim/records/stretch.hpp"

#include <gtest/gtest.h>

namespace {

using host_sim::Quantity;
using host_sim::Record;

Record six_samples() {
  Record record;
  record.sample_period_s = 0.5, record.start_s = 10.0, record.left_out_before = 3;
  record.channels = {{"force_1_N", Quantity::kForce, 1, {0, 1, 2, 3, 4, 5}},
                     {"velocity_1_m_s", Quantity::kVelocity, 1, {5, 4, 3, 2, 1, 0}}};
  return record;
}

// Samples 2 to 4 of 0 to 5: two half seconds later, behind two more of the file.
TEST(Stretch, HasItsStartAndItsNumber) {
  const Record part = stretch_of(six_samples(), 2, 5);
  EXPECT_EQ(part.channels[0].values, (std::vector<double>{2, 3, 4}));
  EXPECT_EQ(part.channels[1].values, (std::vector<double>{3, 2, 1}));
  EXPECT_EQ(part.start_s, 11.0);
  EXPECT_EQ(part.left_out_before, 5u);
}

TEST(Stretch, OfUnevenTimesHasThem) {
  Record record = six_samples();
  record.time_s = {10.0, 10.1, 10.9, 11.0, 12.0, 13.0};
  record.left_out_before.reset();
  const Record part = stretch_of(record, 1, 3);
  EXPECT_EQ(part.time_s, (std::vector<double>{10.1, 10.9}));
  EXPECT_EQ(part.start_s, 10.0);
  EXPECT_FALSE(part.left_out_before.has_value());
}

}  // namespace
