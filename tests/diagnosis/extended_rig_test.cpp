// The rig file that a diagnosis writes is read again, whatever was named.
#include <gtest/gtest.h>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "hal/rig_file/toml/rig_writer.hpp"
#include "host_sim/diagnosis/terms/naming.hpp"

namespace diagnosis {
namespace {

rig_file::RigModel plain_rig(bool rotating) {
  rig_file::RigModel rig;
  rig.name = "one mass";
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].rotating = rotating, rig.dofs[0].mass_kg.value = 2;
  rig.links[0].a = 1, rig.links[0].stiffness_N_m.value = 2000, rig.links[0].viscous_N_s_m.estimate = true;
  return rig;
}

ActiveTerm named(Kind kind, double shape, double shape2) {
  ActiveTerm a;
  const bool on_a_dof = kind == Kind::kMassError || kind == Kind::kResonance;
  a.term = on_a_dof ? on_dof(kind, 0, shape, shape2) : on_link(kind, 0, shape);
  a.term.shape2 = shape2, a.value = 0.5, a.added = true;
  return a;
}

rig_file::RigModel read_again(const rig_file::RigModel& rig) {
  return rig_file::parse_rig(rig_file::format_rig(rig), "extended.toml");
}

bool stands_on(Kind kind, bool rotating) { return firmware::row_of(effect_of(kind)).unit.of(rotating) != nullptr; }

// Every effect of links and DOFs, on what translates and on what turns, with its second shape and without.
TEST(ExtendedRig, IsReadAgainWhateverIsAdded) {
  std::vector<Kind> kinds;
  for (int k = static_cast<int>(Kind::kCubicStiffness); k <= static_cast<int>(Kind::kResonance); ++k)
    kinds.push_back(static_cast<Kind>(k));
  for (const bool rotating : {false, true})
    for (const Kind kind : kinds)
      for (const double shape2 : {0.0, 0.07}) {
        if (!stands_on(kind, rotating)) continue;
        const rig_file::RigModel rig =
            extended_rig(make_system(plain_rig(rotating)), {named(kind, kind == Kind::kResonance ? 30 : 1e-3, shape2)});
        EXPECT_NO_THROW(read_again(rig)) << rig_file::format_rig(rig);
      }
}

// Dahl's bristles the core estimates; LuGre's it does not, and they stand with their value.
TEST(ExtendedRig, WhatTheCoreCannotEstimateStandsWithItsValue) {
  for (const double bristle_time_s : {0.0, 0.07}) {
    const rig_file::RigModel rig =
        read_again(extended_rig(make_system(plain_rig(false)), {named(Kind::kPresliding, 1e-3, bristle_time_s)}));
    ASSERT_EQ(rig.links[0].effects.size(), 1u);
    EXPECT_EQ(rig.links[0].effects[0].coefficient.estimate, bristle_time_s == 0);
    EXPECT_EQ(rig.links[0].effects[0].coefficient.value, bristle_time_s == 0 ? 0 : 0.5);
  }
}

}  // namespace
}  // namespace diagnosis
