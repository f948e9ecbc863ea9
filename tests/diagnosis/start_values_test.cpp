// Masses, springs and dampers that nobody knows, from a noisy motion: first values that a fit can start from.
#include <gtest/gtest.h>

#include <cmath>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/diagnosis/first_values/start.hpp"
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

// A link resists with 2 w - 0.1 w |w| N: the rows give a law that drives, and a run with it ends nowhere. It starts from nought, and the damper
// from what it is without it. Of w = A sin the mean of |w|^3 is 4 A^3 / (3 pi) and of w^2 A^2 / 2, so the damper is 2 - 0.1 * 8 A / (3 pi):
// for A = 4 m/s 1.660 N s/m.
TEST(StartValues, ALawThatWouldDriveStartsFromNought) {
  constexpr double kMass_kg = 2.0, kRate_Hz = 500.0, kTop_m_s = 4.0, kTurn_1_s = 2.0 * M_PI * 2.0;
  std::vector<double> force, x, v, a;
  for (int i = 0; i < 5000; ++i) {
    const double phase = kTurn_1_s * i / kRate_Hz, w = kTop_m_s * std::sin(phase);
    x.push_back(-kTop_m_s / kTurn_1_s * std::cos(phase)), v.push_back(w);
    a.push_back(kTop_m_s * kTurn_1_s * std::cos(phase));
    force.push_back(kMass_kg * a.back() + 2.0 * w - 0.1 * w * std::abs(w));
  }
  const host_sim::Record record = two_masses::of_one_mass("falling.csv", kRate_Hz, force, x, v, a);
  const rig_file::RigModel rig = rig_file::parse_rig(
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\nviscous_N_s_m = \"estimate\"\n"
      "[[link.effect]]\nkind = \"quadratic_damping\"\ncoefficient = \"estimate\"\n",
      "falling.toml");
  const System system = make_system(rig);
  const std::vector<runs::Prepared> records = runs::prepare_all(rig, {record}, {});
  runs::Model model = runs::rig_as_given(system, records);
  runs::start_values(system, records, model);
  for (const runs::ModelTerm& t : model) {
    if (t.term.kind == Kind::kQuadraticDamping) {
      EXPECT_EQ(t.value, 0.0);
    }
    if (t.term.kind == Kind::kViscous) {
      EXPECT_NEAR(t.value, 1.660, 0.01);
    }
  }
}

}  // namespace
