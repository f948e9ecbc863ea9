// Intervals of records with hardly any noise: as wide as elastic forces that are not quite right make the numbers.
#include "host_sim/diagnosis/numbers/elastic_doubt.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/diagnosis/first_values/start.hpp"
#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;

// A mass on 4 kN/m that swings with 20 rad/s: 3e-5 of the spring's force, k X, is a damper of 3e-5 k / w = 6e-3 N s/m.
TEST(ElasticDoubt, OfADamperIsThatOfItsSpringOverTheFrequency) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = 10, rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m.value = 4000, rig.links[0].viscous_N_s_m.estimate = true;
  std::vector<double> x, v, f;
  for (int i = 0; i < 6283; ++i) {
    x.push_back(0.01 * std::sin(0.02 * i)), v.push_back(0.2 * std::cos(0.02 * i));
    f.push_back(std::cos(0.02 * i));
  }
  host_sim::Record record;
  record.sample_period_s = 1e-3;
  record.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, f},
                     {"displacement_1_m", host_sim::Quantity::kDisplacement, 1, x},
                     {"velocity_1_m_s", host_sim::Quantity::kVelocity, 1, v}};
  const System system = make_system(rig);
  const std::vector<runs::Prepared> records = runs::prepare_all(rig, {record}, {});
  const runs::Model model = runs::rig_as_given(system, records);
  const runs::Vec doubt = runs::elastic_doubt({system, records, 1}, model);
  ASSERT_EQ(doubt.size(), 1);
  EXPECT_NEAR(doubt[0], 6e-3, 1e-4);
}

// Clean records of right rigs: what is left is the simulation's own error, the same in all windows.
TEST(ElasticDoubt, CleanRecordsHaveIntervalsThatHold) {
  for (const char* sensors : {"xa", "x"}) {
    hidden_rig::Settings settings;
    settings.condition = "random_clean", settings.sensors = sensors, settings.hidden = "none";
    const hidden_rig::Draw draw = hidden_rig::make_draw(13810002, settings);
    const Diagnosis d = diagnose(draw.rig, draw.records, {});
    EXPECT_EQ(two_masses::said(d), "none");
    for (const hidden_rig::TrueCoefficient& c : draw.coefficients)
      for (const Parameter& p : d.extended.parameters) {
        if (p.name != c.name) continue;
        EXPECT_NEAR(p.value, c.value, 3 * p.std) << sensors << " " << p.name;
        EXPECT_LT(p.std, 0.005 * c.value + 0.005) << sensors << " " << p.name;
      }
  }
}

}  // namespace
