// What the board finds its model to lack while it drives: what it names, what it leaves open, and that it keeps quiet
// about a good model.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/closed_loop/loop.hpp"

namespace {

using namespace closed_loop;
using firmware::Cause;
using firmware::Diagnosis;

firmware::ExcitationProgramme two_frequencies() {
  firmware::ExcitationProgramme programme;
  programme.level_count = 3;
  programme.levels[0] = sine_level(0.5, 12.5, 80);
  programme.levels[1] = sine_level(0.8, 25.0, 40);
  programme.levels[2] = sine_level(0.3, 20.0, 50);
  for (auto& level : programme.levels) level.measure_samples = 3000;
  return programme;
}

firmware::ExcitationProgramme three_levels() {
  firmware::ExcitationProgramme programme;
  programme.level_count = 3;
  const double parts[] = {0.2, 0.5, 0.9};
  for (int i = 0; i < 3; ++i) {
    programme.levels[i] = sine_level(parts[i], 12.5, 80);
    programme.levels[i].measure_samples = 3000;
  }
  return programme;
}

firmware::ExcitationProgramme two_random_levels(uint32_t seed) {
  firmware::ExcitationProgramme programme;
  programme.level_count = 2;
  for (int i = 0; i < 2; ++i) {
    auto& level = programme.levels[i];
    level.kind = firmware::ExcitationKind::kRandomBand;
    level.amplitude = part(i == 0 ? 0.1 : 0.25);
    level.phase_step = step_of(5.0);
    level.high_phase_step = step_of(50.0);
    level.seed = 2 * seed + static_cast<uint32_t>(i);
    level.ramp_samples = 200;
    level.measure_samples = 8000;
  }
  return programme;
}

RigSettings one_dof() {
  RigSettings settings;
  settings.plant = chain({2.0}, 2.0e4, {30.0, 0.0}, 2.0);
  settings.plant.links.pop_back();
  settings.displacement_range_m = 0.02;
  settings.velocity_range_m_s = 2.0;
  settings.acceleration_range_m_s2 = 200.0;
  return settings;
}

RigSettings three_dof() {
  RigSettings settings;
  settings.plant = chain({1.5, 1.3, 2.0}, 1.0e4, {20.0, 20.0, 20.0, 20.0}, 1.0);
  settings.displacement_range_m = 0.02;
  settings.velocity_range_m_s = 2.0;
  settings.acceleration_range_m_s2 = 200.0;
  return settings;
}

Diagnosis watch(Loop& loop) {
  EXPECT_TRUE(loop.run_until(ControllerMode::kDone));
  const hal::CanFrame* frame = loop.can.last(0x481);
  EXPECT_NE(frame, nullptr);
  Diagnosis said;
  if (frame == nullptr) return said;
  firmware::CanFrame message;
  message.id = frame->id;
  message.length = frame->length;
  for (int i = 0; i < frame->length; ++i) message.data[i] = frame->data[i];
  int node = 0;
  EXPECT_TRUE(unpack_diagnosis(message, node, said));
  EXPECT_EQ(said.cause, loop.controller->diagnosis().cause);
  return said;
}

TEST(BoardsWarrant, GoodModelsAreLeftInPeace) {
  Loop sines(one_dof(), two_frequencies());
  EXPECT_EQ(watch(sines).cause, Cause::kNone);
  Loop levels(one_dof(), three_levels());
  EXPECT_EQ(watch(levels).cause, Cause::kNone);
  Loop random(three_dof(), two_random_levels(1));
  EXPECT_EQ(watch(random).cause, Cause::kNone);
}

TEST(BoardsWarrant, NoiseIsNoFinding) {
  for (uint32_t seed = 1; seed <= 4; ++seed) {
    RigSettings settings = three_dof();
    settings.noise_codes = 4000.0;  // of 8.4 million: 1 % and more of these channels' rms
    settings.seed = seed;
    Loop loop(settings, two_random_levels(seed));
    EXPECT_EQ(watch(loop).cause, Cause::kNone) << seed;
  }
}

TEST(BoardsWarrant, WrongSpringIsNamedFromSeveralFrequencies) {
  rig_file::RigModel told = one_dof().plant;
  told.links[0].stiffness_N_m.value *= 1.05;
  Loop loop(one_dof(), told, two_frequencies());
  const Diagnosis said = watch(loop);
  EXPECT_EQ(said.cause, firmware::cause_of(firmware::EffectKind::kStiffnessError));
  EXPECT_EQ(said.place_a, 1);
  EXPECT_EQ(said.place_b, 0);
  EXPECT_GT(said.unexplained_permille, 10);
  EXPECT_GT(said.gained_permille, 800);
}

TEST(BoardsWarrant, WrongMassIsNamedFromSeveralFrequencies) {
  rig_file::RigModel told = one_dof().plant;
  told.dofs[0].mass_kg.value *= 0.95;
  Loop loop(one_dof(), told, two_frequencies());
  const Diagnosis said = watch(loop);
  EXPECT_EQ(said.cause, firmware::cause_of(firmware::EffectKind::kMassError));
  EXPECT_EQ(said.place_a, 1);
  EXPECT_EQ(said.place_b, 31);
}

TEST(BoardsWarrant, OneFrequencyLeavesMassAndSpringOpen) {
  rig_file::RigModel told = one_dof().plant;
  told.links[0].stiffness_N_m.value *= 1.05;
  Loop loop(one_dof(), told, three_levels());
  const Diagnosis said = watch(loop);
  const Cause mass = firmware::cause_of(firmware::EffectKind::kMassError);
  const Cause spring = firmware::cause_of(firmware::EffectKind::kStiffnessError);
  EXPECT_TRUE(said.cause == mass || said.cause == spring) << static_cast<int>(said.cause);
  const Diagnosis& whole = loop.controller->diagnosis();
  EXPECT_EQ(whole.rival, said.cause == mass ? spring : mass);  // and says which other one it may be
}

TEST(BoardsWarrant, HardeningSpringIsNamedFromSeveralLevels) {
  RigSettings settings = one_dof();
  rig_file::Effect cubic;
  cubic.kind = "cubic_stiffness";
  cubic.coefficient.value = 4.0e7;  // at 8 mm: 0.13 of k
  settings.plant.links[0].effects.push_back(cubic);
  Loop loop(settings, one_dof().plant, three_levels());
  const Diagnosis said = watch(loop);
  EXPECT_EQ(said.cause, firmware::cause_of(firmware::EffectKind::kCubicStiffness));
  EXPECT_EQ(said.place_a, 1);
  EXPECT_EQ(said.place_b, 0);
}

TEST(BoardsWarrant, SpringBetweenTwoMassesIsPlaced) {
  rig_file::RigModel told = three_dof().plant;
  told.links[1].stiffness_N_m.value *= 1.15;  // between DOF 1 and 2
  Loop loop(three_dof(), told, two_random_levels(1));
  const Diagnosis said = watch(loop);
  EXPECT_EQ(said.cause, firmware::cause_of(firmware::EffectKind::kStiffnessError));
  EXPECT_EQ(said.place_a, 1);
  EXPECT_EQ(said.place_b, 2);
}

// A Coulomb element that the rig file does not have.
TEST(BoardsWarrant, MissingFrictionIsSeen) {
  RigSettings settings = one_dof();
  settings.plant.links[0].coulomb_N.value = 8.0;
  rig_file::RigModel told = settings.plant;
  told.links[0].coulomb_N.value = 0.0;
  Loop loop(settings, told, three_levels());
  const Diagnosis said = watch(loop);
  EXPECT_EQ(said.cause, firmware::cause_of(firmware::EffectKind::kMissingCoulomb));
  EXPECT_EQ(said.place_a, 1);
  EXPECT_GT(said.unexplained_permille, 30);
  EXPECT_NEAR(loop.controller->diagnosis().size.value * std::pow(10.0, loop.controller->diagnosis().size.exponent), 8.0,
              0.8);
}

TEST(BoardsWarrant, LateSensorIsNamed) {
  RigSettings settings = three_dof();
  settings.late_displacement_dof = 2;  // by one sample period
  Loop loop(settings, two_random_levels(1));
  const Diagnosis said = watch(loop);
  EXPECT_EQ(said.cause, firmware::cause_of(firmware::EffectKind::kSensorDelay));
  EXPECT_EQ(said.place_a, 2);
  EXPECT_EQ(said.quantity, 1);
}

}  // namespace
