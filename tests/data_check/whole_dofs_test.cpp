// All channels of two DOFs exchanged, and a force at another DOF than it acts on: only the masses and springs of the rig file tell.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "tests/data_check/faults.hpp"

namespace {

using faults::all_of;
using faults::find;
using faults::kX1;
using faults::Record;
using faults::Weight;
using faults::with;
using host_sim::Channel;
using host_sim::Quantity;
using host_sim::data_check::check;

// Channels of DOF 1 become those of DOF 2, and the other way round.
void renumber(Record& record, bool motion, bool forces) {
  for (Channel& channel : record.channels) {
    if (!(channel.quantity == Quantity::kForce ? forces : motion)) continue;
    const char from = static_cast<char>('0' + channel.dof);
    channel.dof = 3 - channel.dof;
    channel.name[channel.name.find(from)] = static_cast<char>('0' + channel.dof);
  }
}

// Two masses of 1 kg between three springs of 1000 N/m: seen from either end they are the same. A random force on the first.
const char* const kMirrored =
    "schema = \"rig/1\"\n[[dof]]\nmass_kg = 1\n[[dof]]\nmass_kg = 1\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = 1000\n"
    "viscous_N_s_m = \"estimate\"\n[[link]]\nbetween = [1, 2]\nstiffness_N_m = 1000\nviscous_N_s_m = \"estimate\"\n"
    "[[link]]\nbetween = [2, 0]\nstiffness_N_m = 1000\nviscous_N_s_m = \"estimate\"\n";

Record mirrored_record() {
  Record record;
  record.sample_period_s = 1e-3;
  for (const char* name : {"force_1_N", "displacement_1_m", "displacement_2_m"}) {
    Channel channel;
    channel.name = name;
    channel.quantity = name[0] == 'f' ? Quantity::kForce : Quantity::kDisplacement;
    channel.dof = std::string(name).find('1') != std::string::npos ? 1 : 2;
    record.channels.push_back(channel);
  }
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  double x1 = 0, x2 = 0, v1 = 0, v2 = 0, force = 0;
  constexpr int kSteps = 10;
  for (int k = 0; k < 20000 * kSteps; ++k) {
    if (k % kSteps == 0) {
      force += 0.1 * (30 * normal(random) - force);
      const double values[] = {force, x1 + 1e-6 * normal(random), x2 + 1e-6 * normal(random)};
      for (int c = 0; c < 3; ++c) record.channels[static_cast<size_t>(c)].values.push_back(values[c]);
    }
    constexpr double h = 1e-3 / kSteps;
    v1 += h * (force - 1000 * x1 - 3 * v1 - 1000 * (x1 - x2) - 3 * (v1 - v2));
    v2 += h * (-1000 * x2 - 3 * v2 - 1000 * (x2 - x1) - 3 * (v2 - v1));
    x1 += h * v1, x2 += h * v2;
  }
  return record;
}

// The force at the other DOF says as much as the motion exchanged, and both together nothing: none is named.
TEST(MirroredRig, CannotTell) {
  const rig_file::RigModel rig = rig_file::parse_rig(kMirrored, "rig.toml");
  for (const bool motion : {false, true})
    for (const bool forces : {false, true}) {
      Record record = mirrored_record();
      renumber(record, motion, forces);
      const auto report = check({record}, &rig);
      EXPECT_EQ(all_of(report).find("exchanged"), std::string::npos) << motion << forces << all_of(report);
    }
}

class WholeDofs : public ::testing::TestWithParam<const char*> {
 protected:
  rig_file::RigModel rig_ = made::chain();
  Record record_ = made::record(with(GetParam(), made::Drive::kRandom, 1e-2));
};

TEST_P(WholeDofs, ExchangedAreNamed) {
  renumber(record_, true, false);
  const auto report = check({record_}, &rig_);
  const faults::Finding* finding = nullptr;
  for (const Channel& channel : record_.channels)
    if (channel.quantity != Quantity::kForce && channel.dof == 1) finding = find(report, "exchanged", channel.name);
  ASSERT_NE(finding, nullptr) << all_of(report);
  EXPECT_EQ(finding->weight, Weight::kFault);
  const bool several = std::string(GetParam()).size() > 1;
  EXPECT_EQ(finding->detail.find("(all channels of DOF 1 and DOF 2 are exchanged)") != std::string::npos, several)
      << finding->detail;
}

TEST_P(WholeDofs, AForceAtTheWrongDofIsNamed) {
  renumber(record_, false, true);
  const auto report = check({record_}, &rig_);
  const auto* finding = find(report, "exchanged", "force_2_N");
  ASSERT_NE(finding, nullptr) << all_of(report);
  EXPECT_NE(finding->detail.find("acts on DOF 1, not on DOF 2"), std::string::npos) << finding->detail;
}

// With the masses and springs asked for there is nothing to hold the channels against.
TEST_P(WholeDofs, UnknownMassesAndSpringsCannotTell) {
  renumber(record_, true, false);
  for (rig_file::Dof& dof : rig_.dofs) dof.mass_kg.estimate = true;
  for (rig_file::Link& link : rig_.links) link.stiffness_N_m.estimate = true;
  EXPECT_EQ(all_of(check({record_}, &rig_)).find("exchanged"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Sensors, WholeDofs, ::testing::Values("xva", "xv", "x", "a"));

}  // namespace
