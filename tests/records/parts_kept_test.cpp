// Which of the parts between gaps are read.
#include "host_sim/records/parts_kept.hpp"

#include <gtest/gtest.h>

using host_sim::Quantity;
using host_sim::Record;

namespace {

// An encoder of steps of 0.1 rad that turns back and forth by so many of them, every other sample; and a force that always moves.
Record part(const std::string& name, size_t samples, int steps) {
  Record record;
  record.file = name;
  for (const Quantity quantity : {Quantity::kForce, Quantity::kDisplacement}) {
    host_sim::Channel channel{"", quantity, 1, {}};
    channel.recorded_step = 0.1;
    for (size_t i = 0; i < samples; ++i)
      channel.values.push_back(i % 2 == 0 ? 3.0 : 3.0 + 0.1 * (quantity == Quantity::kForce ? 50 : steps));
    record.channels.push_back(channel);
  }
  return record;
}

std::string names(const std::vector<Record>& parts) {
  std::string text;
  for (const Record& p : parts) text += p.file;
  return text;
}

// Two steps from end to end are a count to either side of a value.
TEST(PartsKept, ThoseAtRestAreLeftOut) {
  std::vector<Record> parts = {part("a", 200, 2), part("b", 200, 3), part("c", 200, 0), part("d", 200, 9)};
  EXPECT_EQ(host_sim::leave_out_parts(parts), "left out: 2 at rest");
  EXPECT_EQ(names(parts), "bd");
}

TEST(PartsKept, ThenTheShortOnes) {
  std::vector<Record> parts = {part("a", 127, 9), part("b", 128, 9), part("c", 300, 1), part("d", 64, 9)};
  EXPECT_EQ(host_sim::leave_out_parts(parts), "left out: 1 at rest, 2 of fewer than 128 samples");
  EXPECT_EQ(names(parts), "b");
}

// Eight levels: of ten parts the longest, and of equal ones the earlier, in their order.
TEST(PartsKept, ThenAllButTheLongest) {
  std::vector<Record> parts;
  const size_t lengths[] = {300, 200, 400, 200, 500, 600, 700, 800, 900, 200};
  for (size_t i = 0; i < std::size(lengths); ++i) parts.push_back(part(std::to_string(i), lengths[i], 9));
  EXPECT_EQ(host_sim::leave_out_parts(parts), "left out: 2 shorter than the 8 longest");
  EXPECT_EQ(names(parts), "01245678");
}

TEST(PartsKept, NeverAllAndNothingOfOne) {
  std::vector<Record> resting = {part("a", 200, 0), part("b", 200, 1)};
  EXPECT_EQ(host_sim::leave_out_parts(resting), "");
  EXPECT_EQ(names(resting), "ab");
  std::vector<Record> one = {part("a", 70, 0)};
  EXPECT_EQ(host_sim::leave_out_parts(one), "");
  EXPECT_EQ(one.size(), 1u);
}

}  // namespace
