// Times in another unit than seconds.
#include <gtest/gtest.h>

#include "tests/data_check/faults.hpp"

namespace {

using faults::all_of;
using faults::find;
using faults::Finding;
using faults::kA1;
using faults::kV1;
using faults::Record;
using faults::Report;
using faults::Weight;
using faults::with;
using host_sim::data_check::check;

// Of the record as a whole; empty: nothing is said of its times.
std::string of_times(const Record& record, bool with_rig) {
  const rig_file::RigModel rig = made::chain();
  const Report report = check({record}, with_rig ? &rig : nullptr);
  for (const Finding& finding : report.records[0].findings)
    if (finding.kind == "unit") return finding.channel + ": " + finding.detail;
  return "";
}

TEST(Faults, TimesInAnotherUnitAreNamedOnce) {
  Record record = made::record(with("xva"));
  EXPECT_EQ(of_times(record, true), "");
  record.sample_period_s *= 1000;  // milliseconds as seconds
  EXPECT_NE(of_times(record, false).find("t_s: the times are in ms"), std::string::npos) << of_times(record, false);
  EXPECT_EQ(find(check({record}, nullptr), "unit", kV1), nullptr);
  EXPECT_EQ(find(check({record}, nullptr), "unit", kA1), nullptr);
}

// A rate that the user tells is none of the file's: the option is to be mended, no column.
TEST(Faults, ARateThatDoesNotGoWithTheMotionIsTheOptions) {
  Record record = made::record(with("xva"));
  record.sample_period_s *= 1000;
  record.times_from = host_sim::TimesFrom::kUser;
  const std::string of_user = of_times(record, true);
  EXPECT_NE(of_user.find("--sample-rate"), std::string::npos) << of_user;
  EXPECT_EQ(of_user.find("column"), std::string::npos) << of_user;
  record.times_from = host_sim::TimesFrom::kFile;
  const std::string of_log = of_times(record, true);
  EXPECT_EQ(of_log.find("column"), std::string::npos) << of_log;
}

// One channel alone tells nothing; the rig does: its modes lie at 3.8 and 8.3 Hz, and the samples come once a second.
TEST(Faults, SamplesTooSlowForEveryModeAreDoubted) {
  Record record = made::record(with("x"));
  rig_file::RigModel rig = made::chain();
  EXPECT_EQ(check({record}, &rig).worst(), Weight::kInforms);
  record.sample_period_s *= 1000;
  const Report report = check({record}, &rig);
  EXPECT_NE(all_of(report).find("are the times in seconds?"), std::string::npos) << all_of(report);
  rig.links[0].stiffness_N_m.estimate = true;  // may be as soft as it likes
  EXPECT_EQ(all_of(check({record}, &rig)).find("are the times in seconds?"), std::string::npos);
}

TEST(Faults, DayNumbersAreNoSeconds) {
  Record record = made::record(with("x"));
  record.start_s = 46082.4, record.sample_period_s = 1e-3 / 86400;
  EXPECT_NE(of_times(record, false).find("the times are days"), std::string::npos);
}

}  // namespace
