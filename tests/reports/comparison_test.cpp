// A record beside two rigs: made by one rig, so that the other's error is known.
#include "host_sim/reports/views/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/plant/motion/simulate.hpp"
#include "host_sim/reports/views/free_simulation.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"

namespace {

using namespace host_sim;

rig_file::RigModel rig(const std::string& link, const char* mass = "mass_kg = 2.0") {
  return rig_file::parse_rig(
      std::string("schema = \"rig/1\"\nname = \"r\"\n[[dof]]\n") + mass + "\n[[link]]\nbetween = [1, 0]\n" + link,
      "rig.toml");
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (double value : values) most = std::max(most, std::abs(value));
  return most;
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> out(a.size());
  for (size_t i = 0; i < a.size(); ++i) out[i] = a[i] - b[i];
  return out;
}

const char kGiven[] = "stiffness_N_m = 800.0\nviscous_N_s_m = 4.0\n";
const char kTrue[] =
    "stiffness_N_m = 800.0\nviscous_N_s_m = 4.0\n[[link.effect]]\nkind = \"cubic_stiffness\"\ncoefficient = 5.0e5\n";

// Free decay of the true rig from 30 mm: 4 s at 1 kHz.
Record decay(const rig_file::RigModel& model) {
  InitialState initial;
  initial.x_m = {0.03};
  Record record = simulate(model, initial, Excitation{}, SampleTimes{1e-3, 0, 0, 4001, 0.0});
  record.file = "decay.csv";
  return record;
}

TEST(Compare, TheRigThatMadeTheRecordLeavesNothing) {
  const Record record = decay(rig(kTrue));
  const auto given = rig(kGiven), truth = rig(kTrue);
  const reports::Comparison out = reports::compare(record, {given}, {truth});
  ASSERT_EQ(out.dofs.size(), 1u);
  ASSERT_EQ(out.dofs[0].waveforms.size(), 2u);
  const reports::Waveform& x = out.dofs[0].waveforms[0];
  EXPECT_EQ(x.quantity, "displacement");
  EXPECT_LT(largest(difference(x.extended, x.measured)), 1e-5 * 0.03);
  EXPECT_GT(largest(difference(x.simulated, x.measured)), 0.3 * 0.03);  // the hardening spring swings faster
}

// A flywheel of 0.01 kg m^2 on a shaft of 4 N m/rad to nothing but another of the same: 20 sqrt(2) rad/s, measured by two rates. How far
// the shaft is twisted at each new start, no sample says; 0.1 rad, it is, at the first.
TEST(Compare, ATwistThatIsNotMeasuredIsFound) {
  const auto shaft = rig_file::parse_rig(
      "schema = \"rig/1\"\nname = \"r\"\n[[dof]]\ninertia_kg_m2 = 0.01\n[[dof]]\ninertia_kg_m2 = 0.01\n[[link]]\n"
      "between = [1, 2]\nstiffness_N_m_rad = 4.0\n",
      "rig.toml");
  const double omega = 20.0 * std::sqrt(2.0);
  Record record;
  record.sample_period_s = 1e-3;
  for (int dof : {1, 2}) {
    std::vector<double> rate;
    for (int k = 0; k < 3500; ++k) rate.push_back((dof == 1 ? -0.05 : 0.05) * omega * std::sin(omega * 1e-3 * k));
    record.channels.push_back({"", Quantity::kVelocity, dof, rate});
  }
  const reports::Comparison out = reports::compare(record, {shaft});
  EXPECT_TRUE(out.free);
  for (const reports::DofView& view : out.dofs)
    EXPECT_LT(largest(difference(view.waveforms[0].simulated, view.waveforms[0].measured)), 1e-3 * 0.05 * omega);
}

// The force left by the rig as given is 5e5 u^3, 13.5 N at 30 mm; the extended rig leaves nothing. Nothing drives the
// mass, so the energy by inertia and springs is what the damper took and the cubic spring holds.
TEST(Compare, ResidualForceIsTheHiddenOne) {
  const Record record = decay(rig(kTrue));
  const auto given = rig(kGiven), truth = rig(kTrue);
  const reports::Comparison out = reports::compare(record, {given}, {truth});
  ASSERT_EQ(out.links.size(), 1u);
  const reports::LinkView& link = out.links[0];
  EXPECT_EQ(link.link, "1-0");
  EXPECT_EQ(link.named_effect, "cubic_stiffness");
  for (size_t i = 0; i < link.residual.size(); i += 50) {
    EXPECT_NEAR(link.residual[i], 5.0e5 * std::pow(link.elongation[i], 3), 0.02);
    EXPECT_NEAR(link.named_force[i], 5.0e5 * std::pow(link.elongation[i], 3), 1e-6);
  }
  EXPECT_LT(largest(link.residual_extended), 0.02);
  const reports::EnergyBalance& energy = out.dofs[0].energy;
  ASSERT_EQ(energy.terms.size(), 2u);
  EXPECT_EQ(energy.terms[0].label, "inertia and springs");
  EXPECT_EQ(energy.terms[1].label, "viscous[1-0]");
  EXPECT_LT(energy.terms[1].values.back(), 0.0);
}

TEST(Compare, ALinkThatOnlyTheExtendedRigHasIsShown) {
  const Record record = decay(rig(kTrue));
  auto extended = rig(kTrue);
  extended.links.push_back(rig("viscous_N_s_m = 1.0\n").links[0]);
  const auto given = rig(kGiven);
  EXPECT_EQ(reports::compare(record, {given}, {extended}).links.size(), 2u);
}

// Without a spring the simulation restarts every second, so an error cannot grow for longer.
TEST(Compare, ARigThatNothingHoldsRestarts) {
  const auto sliding = rig("viscous_N_s_m = 4.0\n");
  EXPECT_FALSE(vocabulary::held_in_place(sliding));
  EXPECT_TRUE(vocabulary::held_in_place(rig(kGiven)));
  InitialState initial;
  initial.v_m_s = {1.0};
  const Record record = simulate(sliding, initial, Excitation{}, SampleTimes{1e-3, 0, 0, 3001, 0.0});
  const auto heavy = rig("viscous_N_s_m = 8.0\n");
  const auto out = reports::compare(record, {heavy}, {sliding});
  ASSERT_EQ(out.notes.size(), 1u);
  const std::vector<double>& x = out.dofs[0].waveforms[0].simulated;
  EXPECT_NEAR(x[1000], record.find(Quantity::kDisplacement, 1)->values[1000], 1e-12);
  EXPECT_GT(std::abs(x[999] - record.find(Quantity::kDisplacement, 1)->values[999]), 1e-3);
}

TEST(Compare, AMasslessRigIsComparedByItsForce) {
  Record record;
  record.sample_period_s = 0.01;
  record.channels = {{"force_1_N", Quantity::kForce, 1, {}}, {"displacement_1_m", Quantity::kDisplacement, 1, {}}};
  for (int i = 0; i < 100; ++i) {  // x = t: w = 1, so f = 3 w + 2
    record.channels[0].values.push_back(5.0);
    record.channels[1].values.push_back(0.01 * i);
  }
  const auto given = rig("viscous_N_s_m = 3.0\n", "mass_kg = 0.0");
  const auto extended = rig("viscous_N_s_m = 3.0\ncoulomb_N = 2.0\n", "mass_kg = 0.0");
  const auto out = reports::compare(record, {given}, {extended});
  const reports::Waveform& force = out.dofs[0].waveforms.at(0);
  EXPECT_EQ(force.quantity, "force");
  EXPECT_NEAR(force.simulated[10], 3.0, 1e-9);
  EXPECT_NEAR(force.extended[10], 5.0, 1e-9);
}

}  // namespace
