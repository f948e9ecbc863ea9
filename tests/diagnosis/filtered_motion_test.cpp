// An anti-alias filter before the motion channels that the force does not pass.
#include "host_sim/diagnosis/channels/filtered_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis::runs;

constexpr double kTwoPi = 6.283185307179586;

// Of fourth order: 1 / sqrt(2) at the corner of 100 Hz, 1 / sqrt(1 + 2^8) an octave above it but for the bilinear transform, which
// takes 200 Hz for tan(0.2 pi) / tan(0.1 pi) = 2.236 times the corner: 1 / sqrt(1 + 2.236^8) = 0.03997.
TEST(FilteredMotion, ForcesPassAButterworth) {
  const double hertz[] = {5, 100, 200}, gain[] = {1, std::sqrt(0.5), 0.03997};
  for (int i = 0; i < 3; ++i) {
    host_sim::Record record;
    record.sample_period_s = 1e-3;
    host_sim::Channel force, motion;
    force.quantity = host_sim::Quantity::kForce, motion.quantity = host_sim::Quantity::kVelocity;
    for (int k = 0; k < 2000; ++k) force.values.push_back(std::sin(kTwoPi * hertz[i] * 1e-3 * k));
    motion.values = force.values, record.channels = {force, motion};
    const std::vector<host_sim::Record> passed = forces_behind({record}, 100);
    double square = 0;
    for (int k = 1000; k < 2000; ++k) square += std::pow(passed[0].channels[0].values[static_cast<size_t>(k)], 2);
    EXPECT_NEAR(std::sqrt(2 * square / 1000), gain[i], 1e-4) << hertz[i];
    EXPECT_EQ(passed[0].channels[1].values, motion.values);
  }
}

// Behind it friction's jumps are rounded and fast motion is later than slow. A plain lag or the filter itself, whichever simulates unseen
// data better, is told; where both do as well the intervals hold both.
TEST(FilteredMotion, NumbersAreThoseOfTheRig) {
  struct Case {
    uint64_t seed;
    const char* sensors;
    int masses;
  };
  int frictions = 0, filters = 0;
  for (const Case& c : {Case{16750001, "mixed", 0}, Case{16750101, "xva", 2}}) {
    hidden_rig::Settings settings;
    settings.condition = "anti_alias_motion_only", settings.sensors = c.sensors, settings.masses = c.masses;
    const hidden_rig::Draw draw = hidden_rig::make_draw(c.seed, settings);
    const diagnosis::Diagnosis d = diagnosis::diagnose(draw.rig, draw.records, {});
    EXPECT_EQ(two_masses::said(d), "none") << c.seed;
    ASSERT_FALSE(d.advice.empty());
    EXPECT_EQ(d.advice[0].rfind("all motion channels lag the force", 0), 0u) << d.advice[0];
    filters += d.advice[0].find("low-pass of fourth order at 2") != std::string::npos;  // 220 Hz
    ASSERT_EQ(d.extended_rig.channels.size(), 1u);
    EXPECT_LT(d.extended_rig.channels[0].delay_us, -1000);
    for (const hidden_rig::TrueCoefficient& truth : draw.coefficients)
      for (const diagnosis::Parameter& p : d.baseline.parameters)
        if (p.name == truth.name) {
          EXPECT_NEAR(p.value, truth.value, 4 * p.std) << c.seed << " " << p.name;
          EXPECT_NEAR(p.value, truth.value, 0.025 * truth.value) << c.seed << " " << p.name;
          frictions += p.name.rfind("coulomb", 0) == 0;
        }
  }
  EXPECT_GE(frictions, 3);
  EXPECT_GE(filters, 1);
}

}  // namespace
