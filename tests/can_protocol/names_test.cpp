// The names and units on the bus are those of the rig file: every coefficient that a rig can have, translating and
// rotating.
#include <gtest/gtest.h>

#include "firmware/can_protocol/messages/messages.hpp"
#include "firmware/can_protocol/messages/packing.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/toml/effect_words.hpp"
#include "host_sim/can_log/known_names.hpp"

namespace {

rig_file::Coefficient unknown() {
  rig_file::Coefficient coefficient;
  coefficient.estimate = true;
  return coefficient;
}

// A DOF on the ground and one on the base, each with one effect of the vocabulary.
rig_file::RigModel rig_with(const firmware::EffectRow* word, bool rotating) {
  rig_file::RigModel model;
  model.dofs.resize(2);
  for (rig_file::Dof& dof : model.dofs) {
    dof.rotating = rotating;
    dof.mass_kg = unknown();
  }
  rig_file::Link link;
  link.a = 1;
  link.b = 2;
  link.stiffness_N_m = link.viscous_N_s_m = link.coulomb_N = unknown();
  if (rotating) link.gravity_torque_N_m = unknown();
  if (word != nullptr) {
    rig_file::Effect effect;
    effect.kind = word->word.text;
    effect.coefficient = unknown();
    for (int i = 0; i < word->shape.count; ++i)
      if (word->shape.at[i].in_core) effect.shape[rig_file::shape_key(*word, i, rotating)] = 0.01;
    link.effects.push_back(effect);
  }
  model.links.push_back(link);
  link.a = 2;
  link.b = rig_file::kBase;
  model.links.push_back(link);
  return model;
}

void expect_same_names(const rig_file::RigModel& model, bool rotating) {
  const firmware::CoreConfiguration configuration = rig_file::compile_rig(model, 1e-3, {});
  const std::vector<rig_file::ParameterInfo> table = rig_file::parameter_table(model);
  ASSERT_EQ(static_cast<size_t>(configuration.unknown_count), table.size());
  can_log::KnownNames names;
  for (size_t i = 0; i < table.size(); ++i) {
    firmware::ParameterDescription description;
    ASSERT_TRUE(firmware::describe_parameter(configuration, static_cast<int>(i), rotating, description));
    names.learn(firmware::pack_parameter(4, description));
    EXPECT_EQ(names.parameter(4, static_cast<int>(i)), table[i].name);
    EXPECT_EQ(names.unit(4, static_cast<int>(i)), table[i].unit) << table[i].name;
  }
  firmware::ParameterDescription none;
  EXPECT_FALSE(firmware::describe_parameter(configuration, static_cast<int>(table.size()), rotating, none));
}

TEST(Names, AreThoseOfTheRigFile) {
  for (bool rotating : {false, true}) expect_same_names(rig_with(nullptr, rotating), rotating);
}

// An effect that corrects a term of the rig file travels as that term: the core knows no other.
TEST(Names, OfEveryEffectThatTheCoreEstimates) {
  int effects = 0;
  for (const firmware::EffectRow& row : firmware::kEffectTable) {
    if (!row.core.estimable || row.role != firmware::EffectRole::kExtension) continue;
    for (bool rotating : {false, true}) {
      SCOPED_TRACE(row.word.text);
      expect_same_names(rig_with(&row, rotating), rotating);
    }
    ++effects;
  }
  EXPECT_GE(effects, 10);
}

}  // namespace
