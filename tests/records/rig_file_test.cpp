// The rig file: what is read, how its unknowns are numbered and named, and that it is written back as it was.
#include <gtest/gtest.h>

#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/toml/rig_reader.hpp"
#include "hal/rig_file/toml/rig_writer.hpp"

namespace {

using firmware::TermKind;

const char* const kChain = R"(schema = "rig/1"
name = "two masses, one moving base"
[[dof]]
mass_kg = 1.5
[[dof]]
mass_kg = "estimate"
[[dof.effect]]
kind = "unmodelled_resonance"
coefficient = 0.1
resonance_Hz = 12.5
damping_ratio = 0.01
[[link]]
between = [1, 0]
stiffness_N_m = 1.0e4
viscous_N_s_m = "estimate"
[[link]]
between = [2, 1]
viscous_N_s_m = 3
coulomb_N = "estimate"
[[link.effect]]
kind = "stribeck"
coefficient = "estimate"
stribeck_velocity_m_s = 0.02
[[link]]
between = [2, "base"]
stiffness_N_m = "estimate"
[[channel]]
name = "force_1_N"
delay_us = 250.0
)";

const char* const kPendulum = R"(schema = "rig/1"
[[dof]]
inertia_kg_m2 = 1.0
[[link]]
between = [1, 0]
gravity_torque_N_m = "estimate"
viscous_N_m_s_rad = "estimate"
coulomb_N_m = "estimate"
)";

TEST(RigFile, ReadsValuesUnknownsEffectsAndChannels) {
  const rig_file::RigModel rig = rig_file::parse_rig(kChain, "chain.toml");
  ASSERT_EQ(rig.dofs.size(), 2u);
  EXPECT_EQ(rig.dofs[0].mass_kg.value, 1.5);
  EXPECT_TRUE(rig.dofs[1].mass_kg.estimate);
  EXPECT_EQ(rig.dofs[1].effects.at(0).shape.at("resonance_Hz"), 12.5);
  ASSERT_EQ(rig.links.size(), 3u);
  EXPECT_EQ(rig.links[0].stiffness_N_m.value, 1.0e4);
  EXPECT_EQ(rig.links[1].viscous_N_s_m.value, 3.0);
  EXPECT_EQ(rig.links[1].effects.at(0).shape.at("stribeck_velocity_m_s"), 0.02);
  EXPECT_EQ(rig.links[2].b, rig_file::kBase);
  EXPECT_EQ(rig.channels.at(0).delay_us, 250.0);
}

TEST(RigFile, ADriftMayLevelOffOrNot) {
  const std::string drift = "[[link.effect]]\nkind = \"drifting_viscous\"\ncoefficient = 0.5\n";
  const auto shapes = [](const std::string& text) {
    return rig_file::parse_rig(text, "rig.toml").links.back().effects.back().shape;
  };
  EXPECT_TRUE(shapes(kPendulum + drift).empty());
  EXPECT_EQ(shapes(kPendulum + drift + "drift_time_s = 4.0\n").at("drift_time_s"), 4.0);
  EXPECT_THROW(shapes(kPendulum + drift + "drift_time_s = 0\n"), std::exception);
}

TEST(RigFile, NamesUnknownsInFileOrderMassesFirst) {
  const auto table = rig_file::parameter_table(rig_file::parse_rig(kChain, "chain.toml"));
  const std::vector<std::pair<std::string, std::string>> expected = {{"mass[2]", "kg"},
                                                                     {"viscous[1-0]", "N s/m"},
                                                                     {"coulomb[2-1]", "N"},
                                                                     {"stribeck[2-1]", "N"},
                                                                     {"stiffness[2-base]", "N/m"}};
  ASSERT_EQ(table.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(table[i].name, expected[i].first);
    EXPECT_EQ(table[i].unit, expected[i].second);
  }
}

TEST(RigFile, RotatingLinksHaveUnitsOfTorque) {
  const auto table = rig_file::parameter_table(rig_file::parse_rig(kPendulum, "pendulum.toml"));
  ASSERT_EQ(table.size(), 3u);
  EXPECT_EQ(table[0].name + " " + table[0].unit, "viscous[1-0] N m s/rad");
  EXPECT_EQ(table[1].name + " " + table[1].unit, "coulomb[1-0] N m");
  EXPECT_EQ(table[2].name + " " + table[2].unit, "gravity_torque[1-0] N m");
}

TEST(RigFile, WrittenRigReadsBackEqual) {
  for (const char* text : {kChain, kPendulum}) {
    const rig_file::RigModel rig = rig_file::parse_rig(text, "first.toml");
    const std::string written = rig_file::format_rig(rig);
    const rig_file::RigModel again = rig_file::parse_rig(written, "second.toml");
    EXPECT_EQ(rig_file::format_rig(again), written);
    EXPECT_EQ(rig_file::parameter_names(again), rig_file::parameter_names(rig));
    EXPECT_EQ(again.dofs[0].mass_kg.value, rig.dofs[0].mass_kg.value);
    EXPECT_EQ(again.links[0].stiffness_N_m.value, rig.links[0].stiffness_N_m.value);
  }
}

TEST(CompileRig, TermsLinksAndUnknownsAgreeWithTheNames) {
  const rig_file::RigModel rig = rig_file::parse_rig(kChain, "chain.toml");
  const firmware::CoreConfiguration core = rig_file::compile_rig(rig, 0.001, {});
  // Terms: m1 known, m2, k10 known, c10, c21 known, F21, stribeck, k2b; the resonance is the simulator's alone.
  ASSERT_EQ(core.term_count, 8);
  ASSERT_EQ(core.unknown_count, 5);
  const TermKind kinds[] = {TermKind::kMass,    TermKind::kMass,    TermKind::kStiffness, TermKind::kViscous,
                            TermKind::kViscous, TermKind::kCoulomb, TermKind::kStribeck,  TermKind::kStiffness};
  const int unknowns[] = {-1, 0, -1, 1, -1, 2, 3, 4};
  const int places[] = {0, 1, 0, 0, 1, 1, 1, 2};
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(core.terms[i].kind, kinds[i]) << i;
    EXPECT_EQ(core.terms[i].unknown, unknowns[i]) << i;
    EXPECT_EQ(core.terms[i].place, places[i]) << i;
  }
  EXPECT_EQ(rig_file::to_double(core.terms[0].value), 1.5);
  EXPECT_EQ(rig_file::to_double(core.terms[6].shape), 0.02);
  EXPECT_EQ(rig_file::to_double(core.sample_period_s), 0.001);
  EXPECT_EQ(core.links[0].node_a, 0);
  EXPECT_EQ(core.links[0].node_b, firmware::kGroundNode);
  EXPECT_EQ(core.links[1].node_a, 1);
  EXPECT_EQ(core.links[1].node_b, 0);
  EXPECT_EQ(core.links[2].node_b, firmware::kBaseNode);
  EXPECT_EQ(rig_file::simulator_only_effects(rig), std::vector<std::string>{"unmodelled_resonance[2]"});
}

TEST(CompileRig, ChannelsKeepCalibrationAndDelay) {
  rig_file::ChannelCalibration force;
  force.quantity = firmware::Quantity::kForce;
  force.dof = 2;
  force.unit_per_code = 0x1p-16;
  force.offset_code = -12;
  force.lowest_code = 0;
  force.highest_code = 65535;
  force.delay_s = 250e-6;
  rig_file::ChannelCalibration base;
  base.dof = rig_file::kBase;
  rig_file::ChannelCalibration first, second;
  second.dof = 2;
  const auto core =
      rig_file::compile_rig(rig_file::parse_rig(kChain, "chain.toml"), 0.001, {force, base, first, second});
  const firmware::ChannelConfiguration& channel = core.channels[1][0];
  EXPECT_TRUE(channel.present);
  EXPECT_EQ(channel.offset_code, -12);
  EXPECT_EQ(channel.lowest_code, 0);
  EXPECT_EQ(channel.highest_code, 65535);
  EXPECT_EQ(channel.delay_ns, 250000);
  EXPECT_EQ(rig_file::to_double(channel.unit_per_code), 0x1p-16);
  EXPECT_FALSE(core.channels[0][0].present);
  EXPECT_TRUE(core.channels[0][1].present);
  EXPECT_TRUE(core.base_present);
  force.dof = 3;
  EXPECT_THROW(rig_file::compile_rig(rig_file::parse_rig(kChain, "chain.toml"), 0.001, {force}),
               rig_file::RigFileError);
}

TEST(CompileRig, WithValuesReplacesEveryUnknownInOrder) {
  const rig_file::RigModel rig = rig_file::with_values(rig_file::parse_rig(kChain, "chain.toml"), {2, 20, 1, 0.5, 7e3});
  EXPECT_TRUE(rig_file::parameter_names(rig).empty());
  EXPECT_EQ(rig.dofs[1].mass_kg.value, 2);
  EXPECT_EQ(rig.links[0].viscous_N_s_m.value, 20);
  EXPECT_EQ(rig.links[1].coulomb_N.value, 1);
  EXPECT_EQ(rig.links[1].effects[0].coefficient.value, 0.5);
  EXPECT_EQ(rig.links[2].stiffness_N_m.value, 7e3);
}

// 1 = 2^61 * 2^-61 and 0.75 = (3 * 2^60) * 2^-62, worked by hand; the mantissa lies in [2^61, 2^62).
TEST(ScaledDouble, IsNormalisedAndExact) {
  EXPECT_EQ(rig_file::to_scaled(1.0).mantissa, int64_t{1} << 61);
  EXPECT_EQ(rig_file::to_scaled(1.0).exponent, -61);
  EXPECT_EQ(rig_file::to_scaled(-0.75).mantissa, -(int64_t{3} << 60));
  EXPECT_EQ(rig_file::to_scaled(-0.75).exponent, -62);
  EXPECT_TRUE(rig_file::to_scaled(0.0).is_zero());
  for (const double value : {5e-6, 1e9, -1.0 / 3.0, 2.5e-300, 1e300}) {
    EXPECT_EQ(rig_file::to_double(rig_file::to_scaled(value)), value);
  }
}

}  // namespace
