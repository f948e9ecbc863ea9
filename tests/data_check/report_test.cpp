// What a report says of every channel, and its fields as JSON.
#include <gtest/gtest.h>

#include "tests/data_check/faults.hpp"

namespace {

using faults::kA1;
using faults::Record;
using faults::Report;
using faults::times;
using faults::with;
using host_sim::data_check::check;
using host_sim::data_check::to_json;

TEST(Faults, NoiseFloorAndResolutionAreMeasured) {
  made::Options options = with("x", made::Drive::kRandom, 0.01);
  Record record = made::record(options);
  const Report fine = check({record}, nullptr);
  const auto& channel = fine.records[0].channels[1];
  EXPECT_NEAR(channel.noise_floor, 0.01 * channel.rms, 0.0005 * channel.rms);
  EXPECT_EQ(channel.resolution, 0.0);
  options.encoder_m = 1e-4;
  options.noise = 0.0;
  const Report coarse = check({made::record(options)}, nullptr);
  EXPECT_NEAR(coarse.records[0].channels[1].resolution, 1e-4, 1e-9);
}

TEST(Faults, JsonHasTheFieldsOfTheContract) {
  Record record = made::record(with("xa"));
  times(kA1, -1)(record);
  const auto json = to_json(check({record}, nullptr));
  EXPECT_EQ(json["schema"], "check/1");
  EXPECT_EQ(json["verdict"], "unusable");
  EXPECT_EQ(json["records"][0]["file"], "made.csv");
  EXPECT_EQ(json["records"][0]["samples"], 20000);
  EXPECT_DOUBLE_EQ(json["records"][0]["sample_rate_Hz"], 1000.0);
  EXPECT_EQ(json["records"][0]["channels"][2]["name"], kA1);
  EXPECT_EQ(json["records"][0]["channels"][2]["findings"][0]["kind"], "polarity");
  EXPECT_TRUE(json["records"][0]["channels"][2].contains("noise_floor"));
  EXPECT_TRUE(json["records"][0]["channels"][2].contains("rms"));
  EXPECT_TRUE(json["findings"].is_array());
}

}  // namespace
