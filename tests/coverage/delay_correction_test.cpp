// A displacement that is late is taken out by `host_sim estimate`, and it is said.
#include <gtest/gtest.h>

#include <algorithm>

#include "host_sim/programs/estimate/estimation.hpp"
#include "tests/hidden_rig/draw.hpp"

namespace {

hidden_rig::Draw two_masses(uint64_t seed) {
  hidden_rig::Settings settings;
  settings.masses = 2;
  return hidden_rig::make_draw(seed, settings);
}

void delay_by_one_sample(host_sim::Record& record, const std::string& name) {
  for (host_sim::Channel& channel : record.channels)
    if (channel.name == name)
      std::copy_backward(channel.values.begin(), channel.values.end() - 1, channel.values.end());
}

bool said(const host_sim::Estimation& estimation, const std::string& text) {
  return std::any_of(estimation.result.notes.begin(), estimation.result.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

// One sample at 1 kHz: 1000 us. Left alone it adds k tau, 4 to 30 N s/m, to a damper of 8 to 40.
TEST(DelayCorrection, TakesALateDisplacementOut) {
  for (uint64_t seed = 6000; seed < 6003; ++seed) {
    hidden_rig::Draw draw = two_masses(seed);
    delay_by_one_sample(draw.records[0], "displacement_2_m");
    const host_sim::Estimation estimation = host_sim::estimate_records(draw.rig, draw.records, {});
    EXPECT_TRUE(said(estimation, "displacement_2_m was ")) << seed;
    EXPECT_TRUE(said(estimation, " us late against the other channels of its DOF")) << seed;
    for (size_t k = 0; k < draw.coefficients.size(); ++k) {
      const host_sim::ParameterResult& p = estimation.result.parameters[k];
      EXPECT_NEAR(p.value, draw.coefficients[k].value, 0.02 * draw.coefficients[k].value + 4 * p.std)
          << seed << " " << p.info.name;
    }
  }
}

TEST(DelayCorrection, SaysNothingWhereNothingIsLate) {
  for (uint64_t seed = 6000; seed < 6003; ++seed) {
    const hidden_rig::Draw draw = two_masses(seed);
    EXPECT_FALSE(said(host_sim::estimate_records(draw.rig, draw.records, {}), "corrected")) << seed;
  }
}

// Displacement and acceleration late by the same time against the velocity: it is the velocity that is early... or, here, late.
TEST(DelayCorrection, BlamesTheVelocityWhereTheOtherTwoAgree) {
  hidden_rig::Draw draw = two_masses(6001);
  delay_by_one_sample(draw.records[0], "velocity_1_m_s");
  const host_sim::Estimation estimation = host_sim::estimate_records(draw.rig, draw.records, {});
  EXPECT_TRUE(said(estimation, "velocity_1_m_s was "));
}

}  // namespace
