// Every instant is told in the file's own seconds, every sample by its number in the file.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/records/times/resample.hpp"
#include "host_sim/records/times/time_span.hpp"

namespace {

using host_sim::Quantity;
using host_sim::Record;
using host_sim::data_check::check;
using host_sim::data_check::Report;

// 0.5 Hz at 100 Hz for 200 s, from 1.00 s on; a glitch in sample 1661 of the file, counted from 1: at 1 + 1660 * 0.01 = 17.6 s.
Record with_a_glitch() {
  Record record;
  record.file = "made.csv", record.sample_period_s = 0.01, record.start_s = 1.0;
  record.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, {}}};
  for (int i = 0; i < 20000; ++i)
    record.channels[0].values.push_back(0.1 * std::sin(M_PI * 0.01 * i) + 1e-5 * std::sin(12.9898 * (i * i % 7919)));
  record.channels[0].values[1660] += 0.7;
  return record;
}

std::string told(const Record& record, const std::string& kind) {
  const Report report = check({record}, nullptr);
  for (const auto& channel : report.records[0].channels)
    for (const auto& finding : channel.findings)
      if (finding.kind == kind) return finding.detail;
  return "";
}

TEST(Instants, OfASpikeAreTheFilesOwn) {
  for (const double from_s : {0.0, 5.0, 17.5}) {
    const std::string said = told(host_sim::within(with_a_glitch(), {from_s, 1e9}), "spikes");
    EXPECT_NE(said.find("at 17.6 s (sample 1661)"), std::string::npos) << from_s << ": " << said;
  }
}

// Interpolated rows are no samples of the file.
TEST(Instants, OfResampledRowsHaveNoSampleNumber) {
  const std::string said = told(host_sim::resampled(with_a_glitch(), 100.0).front(), "spikes");
  EXPECT_NE(said.find("at 17.6 s is"), std::string::npos) << said;
}

// The second of two channels stops at sample 12,000: at 1 + 120 = 121 s.
TEST(Instants, OfASensorThatStopsAreTheFilesOwn) {
  Record record = with_a_glitch();
  record.channels.push_back(record.channels[0]);
  record.channels[1].name = "velocity_1_m_s", record.channels[1].quantity = Quantity::kVelocity;
  for (int i = 0; i < 20000; ++i)
    record.channels[1].values[static_cast<size_t>(i)] =
        i < 12000 ? 0.1 * M_PI * std::cos(M_PI * 0.01 * i) : 1e-5 * std::sin(12.9898 * (i * i % 7919));
  const std::string said = told(record, "dead");
  EXPECT_NE(said.find("near 121 s"), std::string::npos) << said;
}

// A long record that begins late still tells its samples apart.
TEST(Instants, GoToTheSample) {
  Record record;
  record.sample_period_s = 1e-3, record.start_s = 86400.0;
  record.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, std::vector<double>(100000, 0.0)}};
  record.left_out_before = 10;
  EXPECT_EQ(host_sim::data_check::said_sample(record, 12345), "86412.345 s (sample 12356)");
}

}  // namespace
