// The part of a record between two instants.
#include "host_sim/records/times/time_span.hpp"

#include <gtest/gtest.h>

#include "host_sim/records/files/data_file_error.hpp"

namespace {

using host_sim::Record;
using host_sim::TimeSpan;
using host_sim::within;

// 0, 1, 2 ... every 0.1 s from 5 s on: 5.0, 5.1 ... 5.9.
Record ten() {
  Record record;
  record.file = "ten.csv";
  record.start_s = 5, record.sample_period_s = 0.1;
  record.channels.push_back({"force_1_N", host_sim::Quantity::kForce, 1, {}});
  record.channels.push_back({"displacement_1_m", host_sim::Quantity::kDisplacement, 1, {}});
  for (int i = 0; i < 10; ++i)
    for (host_sim::Channel& channel : record.channels) channel.values.push_back(i);
  return record;
}

std::string refusal(const Record& record, const TimeSpan& span) {
  try {
    within(record, span);
  } catch (const host_sim::DataFileError& error) {
    return error.what();
  }
  return "";
}

// 5 + 0.1 * 3 is no binary fraction: both ends that are meant belong to it.
TEST(TimeSpan, BothEndsBelongToIt) {
  const Record part = within(ten(), {5.3, 5.6});
  for (const host_sim::Channel& channel : part.channels)
    EXPECT_EQ(channel.values, (std::vector<double>{3, 4, 5, 6})) << channel.name;
  EXPECT_NEAR(part.start_s, 5.3, 1e-12);
  ASSERT_EQ(part.notes.size(), 1u);
  EXPECT_EQ(part.notes[0], "taken from 5.3 to 5.6 s: 4 of 10 samples");
  EXPECT_EQ(part.left_out_before, 3u);
  EXPECT_EQ(within(part, {5.5, 6}).left_out_before, 5u);
}

TEST(TimeSpan, AnOpenEndTakesAll) {
  EXPECT_EQ(within(ten(), {5.75, TimeSpan().to_s}).channels[0].values, (std::vector<double>{8, 9}));
  EXPECT_EQ(within(ten(), {TimeSpan().from_s, 5.12}).channels[0].values, (std::vector<double>{0, 1}));
  EXPECT_EQ(within(ten(), {-3, 1e9}).samples(), 10u);
  EXPECT_TRUE(TimeSpan().is_all());
}

TEST(TimeSpan, UnevenTimesAreTheirOwn) {
  Record record = ten();
  record.time_s = {0, 1, 3, 3.5, 4, 7, 8, 9, 11, 12};
  const Record part = within(record, {1, 3.6});
  EXPECT_EQ(part.time_s, (std::vector<double>{1, 3, 3.5}));
  EXPECT_EQ(part.channels[1].values, (std::vector<double>{1, 2, 3}));
}

TEST(TimeSpan, NothingLeftIsRefusedWithWhatThereIs) {
  EXPECT_EQ(refusal(ten(), {6, 7}),
            "ten.csv: has 0 samples from --from to --to, expected at least 2: it goes from 5 to 5.9 s");
  EXPECT_EQ(refusal(ten(), {5.85, 7}),
            "ten.csv: has 1 samples from --from to --to, expected at least 2: it goes from 5 to 5.9 s");
}

}  // namespace
