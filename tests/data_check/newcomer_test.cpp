// What the check says of records that a newcomer brings.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/report/to_json.hpp"

namespace {

using host_sim::Quantity;
using host_sim::Record;

Record swing(size_t samples, double step_s, double start_s = 0.0) {
  Record record;
  record.file = "made.csv", record.sample_period_s = step_s, record.start_s = start_s;
  record.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, {}},
                     {"velocity_1_m_s", Quantity::kVelocity, 1, {}}};
  for (size_t i = 0; i < samples; ++i) {
    const double t = 2e-3 * static_cast<double>(i);
    record.channels[0].values.push_back(std::exp(-0.2 * t) * std::sin(40 * t));
    record.channels[1].values.push_back(std::exp(-0.2 * t) * (40 * std::cos(40 * t) - 0.2 * std::sin(40 * t)));
  }
  return record;
}

std::string faults(const Record& record) {
  std::string text;
  for (const std::string& line : host_sim::data_check::lines_of(host_sim::data_check::check({record}, nullptr),
                                                                host_sim::data_check::Weight::kFault))
    text += line + "\n";
  return text;
}

TEST(Newcomer, AHandfulOfSamplesIsNoRecord) {
  EXPECT_NE(faults(swing(20, 2e-3)).find("short: holds 20 samples"), std::string::npos) << faults(swing(20, 2e-3));
  EXPECT_EQ(faults(swing(2000, 2e-3)), "");
}

TEST(Newcomer, TimesInMillisecondsMayBeWhyAVelocityIsTooLarge) {
  const std::string said = faults(swing(4000, 2.0));
  EXPECT_NE(said.find("or the times are in ms (--unit t=ms)"), std::string::npos) << said;
}

TEST(Newcomer, DaysOfASpreadsheetAreSaidAlone) {
  const std::string said = faults(swing(4000, 2e-3 / 86400.0, 45000.0));
  EXPECT_NE(said.find("the times are days"), std::string::npos) << said;
  EXPECT_EQ(said.find("velocity_1_m_s: unit"), std::string::npos) << said;
}

}  // namespace
