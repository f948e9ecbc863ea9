// Files of one session that do not go together.
#include "host_sim/data_check/together/unlike.hpp"

#include <gtest/gtest.h>

#include "host_sim/data_check/report/to_json.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/record_checks.hpp"
#include "tests/data_check/made_records.hpp"

namespace {

using host_sim::Record;
using host_sim::data_check::find_unlike;

Record named(const char* file, double rate_Hz, const char* sensors) {
  made::Options options;
  options.rate_Hz = rate_Hz, options.sensors = sensors;
  Record record = made::record(options);
  record.file = file;
  return record;
}

TEST(Unlike, RecordsOfOtherRatesAreToldWithTheOption) {
  const auto found = find_unlike({named("a.csv", 1000, "xv"), named("b.csv", 500, "xv")});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].detail.find("b.csv has 500 samples a second, a.csv 1000"), std::string::npos) << found[0].detail;
  EXPECT_NE(found[0].detail.find("--resample 1000"), std::string::npos) << found[0].detail;
  EXPECT_STREQ(host_sim::data_check::check({named("a.csv", 1000, "xv"), named("b.csv", 500, "xv")}, nullptr).verdict(),
               "usable");
}

TEST(Unlike, RecordsOfOtherChannelsAreToldWithWhatIsLacking) {
  const auto found = find_unlike({named("a.csv", 1000, "xv"), named("b.csv", 1000, "xa")});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].detail.find("lacks velocity_1_m_s, velocity_2_m_s and has acceleration_1_m_s2"), std::string::npos)
      << found[0].detail;
}

TEST(Unlike, OneSessionIsOne) {
  EXPECT_TRUE(find_unlike({named("a.csv", 1000, "xv"), named("b.csv", 1000, "xv")}).empty());
  EXPECT_TRUE(find_unlike({named("a.csv", 1000, "xv"), named("b.csv", 1000.2, "xv")}).empty());
}

// The estimation counts all records at the first one's rate: 0.8 % there is 1.6 % of a spring.
TEST(Unlike, RatesThatNearlyAgreeDoNot) {
  const std::vector<Record> near = {named("a.csv", 1000, "xv"), named("b.csv", 1008, "xv")};
  EXPECT_EQ(find_unlike(near).size(), 1u);
  EXPECT_THROW(host_sim::require_same_channels(near), host_sim::DataFileError);
}

}  // namespace
