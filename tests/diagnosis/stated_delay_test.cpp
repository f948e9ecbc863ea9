// A delay that the rig file states is taken out of all that is fitted, the free runs too, and is no cause.
#include <gtest/gtest.h>

#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

// Of two milliseconds, in a decay: the free runs are all that is asked there.
TEST(StatedDelay, IsNoCauseOfADecay) {
  for (const char* sensors : {"xa", "xv"})
    for (uint64_t seed : {41, 42, 43}) {
      hidden_rig::Settings settings;
      settings.condition = "free_decay", settings.sensors = sensors, settings.hidden = "sensor_delay";
      settings.fault = 0.002, settings.masses = 1;
      const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
      rig_file::RigModel rig = draw.rig;
      rig_file::ChannelEntry entry;
      entry.name = draw.hidden[0].where.substr(std::string("channel ").size());
      entry.delay_us = 1e6 * draw.hidden[0].strength;
      rig.channels.push_back(entry);
      EXPECT_NE(diagnosis::diagnose(draw.rig, draw.records, {}).verdict, diagnosis::Verdict::kNone) << sensors << seed;
      const diagnosis::Diagnosis stated = diagnosis::diagnose(rig, draw.records, {});
      EXPECT_EQ(stated.verdict, diagnosis::Verdict::kNone)
          << sensors << seed << entry.name << ": " << two_masses::said(stated);
    }
}

}  // namespace
