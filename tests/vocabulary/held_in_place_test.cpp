// What counts as a spring that holds: by hand, for every row that could.
#include "host_sim/vocabulary/held_in_place.hpp"

#include <gtest/gtest.h>

#include <set>

#include "firmware/vocabulary/effect_table.hpp"

TEST(HeldInPlace, TheKindsThatPullBack) {
  using firmware::EffectKind;
  const std::set<EffectKind> expected = {EffectKind::kStiffness,      EffectKind::kStiffnessError,
                                         EffectKind::kGravityTorque,  EffectKind::kMissingGravityTorque,
                                         EffectKind::kCubicStiffness, EffectKind::kEndStop};
  for (const firmware::EffectRow& row : firmware::kEffectTable)
    if (row.role != firmware::EffectRole::kCorrection || expected.count(row.kind) > 0) {
      EXPECT_EQ(vocabulary::pulls_back(row.kind), expected.count(row.kind) > 0) << row.word.text;
    }
}

// 1 on a spring to the ground, 2 behind it on a damper: 2 floats. A correction that takes the spring away lets 1 go too.
TEST(HeldInPlace, ByChainsOfSprings) {
  rig_file::RigModel rig;
  rig.dofs.resize(2);
  rig_file::Link ground, between;
  ground.a = 1, ground.b = 0, ground.stiffness_N_m.value = 100.0;
  between.a = 1, between.b = 2, between.viscous_N_s_m.value = 3.0;
  rig.links = {between, ground};
  EXPECT_FALSE(vocabulary::held_in_place(rig));
  rig.links[0].effects.push_back({"cubic_stiffness", {5.0, false}, {}});
  EXPECT_TRUE(vocabulary::held_in_place(rig));
  rig.links[1].effects.push_back({"stiffness_error", {-100.0, false}, {}});
  EXPECT_FALSE(vocabulary::held_in_place(rig));
  rig.links[1].b = rig_file::kBase, rig.links[1].effects.clear();
  EXPECT_TRUE(vocabulary::held_in_place(rig));
}
