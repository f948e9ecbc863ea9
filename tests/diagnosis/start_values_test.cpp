// Masses, springs and dampers that nobody knows, from a noisy motion: first values that a fit can start from.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/diagnosis/fit/start.hpp"
#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;

hidden_rig::Draw rig_of_unknown_masses(uint64_t seed) {
  hidden_rig::Settings settings;
  settings.condition = "masses_springs_unknown", settings.sensors = "x", settings.hidden = "none";
  return hidden_rig::make_draw(seed, settings);
}

// The force acts on one of the masses, displacements are all that is known, with 1 % of noise: of the second differences at the
// sampling rate that is most. A fit reaches a mass from half of it, or twice.
TEST(StartValues, AreOfTheSizeOfMassesThatNothingDrives) {
  for (const uint64_t seed : {16300001u, 910001u, 910002u, 910003u}) {
    const hidden_rig::Draw draw = rig_of_unknown_masses(seed);
    const System system = make_system(draw.rig);
    const std::vector<runs::Prepared> records = runs::prepare_all(draw.rig, draw.records, {});
    runs::Model model = runs::rig_as_given(system, records);
    runs::start_values(system, records, model);
    size_t compared = 0;
    for (const runs::ModelTerm& t : model)
      for (const hidden_rig::TrueCoefficient& c : draw.coefficients) {
        if (t.term.kind != Kind::kMass || c.name != "mass[" + std::to_string(t.term.dof + 1) + "]") continue;
        EXPECT_LT(std::abs(std::log(t.value / c.value)), std::log(2.0)) << seed << " " << c.name << " " << t.value;
        ++compared;
      }
    EXPECT_EQ(compared, draw.rig.dofs.size());
  }
}

TEST(StartValues, LeadToTheRightRig) {
  const hidden_rig::Draw draw = rig_of_unknown_masses(16300001);
  const Diagnosis d = diagnose(draw.rig, draw.records, {});
  EXPECT_EQ(two_masses::said(d), "none");
  for (const hidden_rig::TrueCoefficient& c : draw.coefficients)
    for (const Parameter& p : d.extended.parameters) {
      if (p.name == c.name) {
        EXPECT_NEAR(p.value, c.value, 4 * p.std) << p.name;
      }
    }
}

}  // namespace
