// Friction where it is hard: loops of held links, stick-slip, many events, negative levels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/plant/motion/simulate.hpp"
#include "tests/plant/rigs.hpp"

namespace {

using host_sim::Quantity;
using plant_test::oscillator;

const std::vector<double>& channel(const host_sim::Record& record, Quantity quantity, int dof = 1) {
  return record.find(quantity, dof)->values;
}

// Slowly rising force. Two bodies of 1 kg, body 1
// held to body 2 (2 N) and to the ground (1 N), body 2 to the ground (1 N): a loop of three. All of it lets go when the
// force on body 1 exceeds 1 N + min(2 N, 1 N) = 2 N: body 1's own grip on the ground, and what body 2 can take over.
TEST(Friction, ALoopOfHeldLinksLetsGoAtTheSumOfWhatItCanCarry) {
  rig_file::RigModel rig = oscillator(1.0, 0.0, 0.0, 1.0);
  rig.dofs.push_back(rig.dofs[0]);
  rig_file::Link middle = rig.links[0], second = rig.links[0];
  middle.b = 2;
  middle.coulomb_N.value = 2.0;
  second.a = 2;
  rig.links.push_back(middle);
  rig.links.push_back(second);
  host_sim::Excitation excitation;
  excitation.force_N = {host_sim::cosine(3.0, 0.25, -1.57079632679489662), nullptr};  // 3 sin(2 pi t / 4) N
  const auto record = host_sim::simulate(rig, {}, excitation, {1e-3, 0, 0, 1001, 0.0});
  const double release_s = std::asin(2.0 / 3.0) * 4.0 / (2 * 3.14159265358979323846);
  for (size_t k = 0; k < 1001; ++k) {
    const double t = 1e-3 * static_cast<double>(k);
    if (t < release_s) {
      EXPECT_EQ(channel(record, Quantity::kVelocity, 1)[k], 0.0) << k;
    }
    if (t > release_s + 1e-3) {
      EXPECT_GT(channel(record, Quantity::kVelocity, 1)[k], 0.0) << k;
    }
    // while body 2 is carried along (inertia force below what the middle link holds) the two move as one
    EXPECT_EQ(channel(record, Quantity::kVelocity, 1)[k], channel(record, Quantity::kVelocity, 2)[k]) << k;
  }
}

// A block of 1 kg on a belt (the base, 0.1 m/s) with Stribeck friction, tied by 100 N/m: it sticks to the belt, is
// pulled back and slips again. F = 1 N, Fs = 0.5 N: it rides with the belt until 100 u = 1.5 N, u = 0.015 m, every
// cycle.
TEST(Friction, StickSlipRidesTheBeltToTheHoldLevel) {
  rig_file::RigModel rig = oscillator(1.0, 100.0);
  rig_file::Link belt;
  belt.a = 1;
  belt.b = rig_file::kBase;
  belt.coulomb_N.value = 1.0;
  belt.effects.push_back(plant_test::effect("stribeck", 0.5, "stribeck_velocity_m_s", 0.05));
  rig.links.push_back(belt);
  // the belt: x = 0.1 t, as a slow wide cosine near its steepest point (0.1 m/s within 1e-4 over 4 s)
  const double f = 1e-3, amplitude = 0.1 / (2 * 3.14159265358979323846 * f);
  host_sim::Excitation excitation;
  excitation.base_m = host_sim::cosine(amplitude, f, -1.57079632679489662);
  const auto record = host_sim::simulate(rig, {{0.0}, {0.1}}, excitation, {1e-3, 0, 0, 4001, 0.0});
  const auto& v = channel(record, Quantity::kVelocity);
  const auto& belt_v = record.find(Quantity::kVelocity, rig_file::kBase)->values;
  int stuck = 0, slips = 0;
  for (size_t k = 1; k < v.size(); ++k) {
    stuck += v[k] == belt_v[k] ? 1 : 0;
    if (v[k - 1] == belt_v[k - 1] && v[k] != belt_v[k]) {
      ++slips;
      EXPECT_NEAR(channel(record, Quantity::kDisplacement)[k - 1], 0.01495, 6e-5);  // within the last sample, 0.1 mm
    }
    EXPECT_LE(v[k], belt_v[k] + 1e-9);  // friction cannot throw it ahead of the belt
  }
  EXPECT_GT(stuck, 200);
  EXPECT_GE(slips, 3);
}

// A negative level (an estimate may be) cannot hold anything: from 0.1 m with F = -1, k = 100, m = 1 the first half
// swing is about -F/k ... centre -0.01: it ends at -0.12, the next at +0.14: it gains 4 |F| / k = 0.04 m a cycle.
TEST(Friction, ANegativeLevelDrives) {
  const double half = 3.14159265358979323846 / 10.0;
  const auto record =
      host_sim::simulate(oscillator(1.0, 100.0, 0.0, -1.0), {{0.1}, {0.0}}, {}, {half / 100, 0, 0, 401, 0.0});
  const double turning[] = {0.1, -0.12, 0.14, -0.16, 0.18};
  for (size_t k = 0; k < 5; ++k) EXPECT_NEAR(channel(record, Quantity::kDisplacement)[100 * k], turning[k], 1e-8);
}

// From rest at the centre under 1 N against 2 N nothing ever moves, exactly; five links in a chain.
TEST(Friction, AChainAtRestStaysAtRest) {
  rig_file::RigModel rig = oscillator(1.0, 1e4, 20.0, 2.0);
  for (int i = 2; i <= 5; ++i) {
    rig.dofs.push_back(rig.dofs[0]);
    rig.links.push_back(rig.links[0]);
    rig.links.back().a = i;
    rig.links.back().b = i - 1;
  }
  host_sim::Excitation excitation;
  excitation.force_N = {nullptr, nullptr, nullptr, nullptr, host_sim::cosine(1.0, 3.0)};
  const auto record = host_sim::simulate(rig, {}, excitation, {1e-3, 0, 0, 2001, 0.0});
  for (int dof = 1; dof <= 5; ++dof)
    for (size_t k = 0; k < 2001; ++k) ASSERT_EQ(channel(record, Quantity::kDisplacement, dof)[k], 0.0);
}

// Energy of a chain with friction in every link, driven hard, may only be lost where the force does no work: after the
// force is gone it must fall from sample to sample, and the chain must come to rest for good.
TEST(Friction, AChainComesToRest) {
  rig_file::RigModel rig = oscillator(1.0, 1e4, 0.0, 3.0);
  for (int i = 2; i <= 4; ++i) {
    rig.dofs.push_back(rig.dofs[0]);
    rig.links.push_back(rig.links[0]);
    rig.links.back().a = i;
    rig.links.back().b = i - 1;
  }
  const auto record = host_sim::simulate(rig, {{0.01, -0.005, 0.008, 0.02}, {}}, {}, {1e-3, 0, 0, 4001, 0.0});
  double last = 1e9;
  for (size_t k = 0; k < 4001; ++k) {
    double energy = 0.0;
    for (int dof = 1; dof <= 4; ++dof) {
      const double v = channel(record, Quantity::kVelocity, dof)[k];
      const double u = channel(record, Quantity::kDisplacement, dof)[k] -
                       (dof > 1 ? channel(record, Quantity::kDisplacement, dof - 1)[k] : 0.0);
      energy += 0.5 * v * v + 5e3 * u * u;
    }
    EXPECT_LE(energy, last * (1.0 + 1e-9));
    last = energy;
  }
  for (int dof = 1; dof <= 4; ++dof) EXPECT_EQ(channel(record, Quantity::kVelocity, dof).back(), 0.0);
}

// 2 kg and 6 kg held to each other by F = 10 N, free otherwise, 4 N on the first: both go with 4 / 8 = 0.5 m/s^2, and
// the link carries 6 * 0.5 = 3 N.
TEST(Friction, HeldBodiesOfUnequalMassMoveAsOne) {
  rig_file::RigModel rig = plant_test::oscillator(2.0, 0.0, 0.0, 10.0, 2);
  rig.dofs.push_back(rig.dofs[0]);
  rig.dofs[1].mass_kg.value = 6.0;
  host_sim::Excitation excitation;
  excitation.force_N = {host_sim::cosine(4.0, 0.0), nullptr};
  const host_sim::Record record = host_sim::simulate(rig, {}, excitation, {1e-3, 0, 0, 1001});
  for (const int dof : {1, 2}) {
    EXPECT_NEAR(record.find(host_sim::Quantity::kAcceleration, dof)->values[1000], 0.5, 1e-12);
    EXPECT_NEAR(record.find(host_sim::Quantity::kDisplacement, dof)->values[1000], 0.25, 1e-9);
  }
}

// A rig with friction between two masses, sticking again and again, and the same with every mass, coefficient and force
// multiplied by 1e-9 or by 1e9: the motion is the same.
TEST(Friction, MotionDoesNotDependOnTheScaleOfForces) {
  const auto motion = [](double scale) {
    rig_file::RigModel rig = plant_test::oscillator(1.5 * scale, 1e4 * scale, 2.0 * scale);
    rig.dofs.push_back(rig.dofs[0]);
    rig.dofs[1].mass_kg.value = 1.3 * scale;
    rig.links.push_back(plant_test::oscillator(1.0, 1e4 * scale, 2.0 * scale, 5.0 * scale, 2).links[0]);
    host_sim::Excitation excitation;
    excitation.force_N = {host_sim::random_band({20.0 * scale, 2.0, 30.0}, 0.0, 2.0, 1e-3, 7, 0), nullptr};
    return host_sim::simulate(rig, {}, excitation, {1e-3, 0, 0, 1001})
        .find(host_sim::Quantity::kDisplacement, 2)
        ->values;
  };
  const std::vector<double> one = motion(1.0), small = motion(1e-9), large = motion(1e9);
  const double largest = std::fabs(
      *std::max_element(one.begin(), one.end(), [](double a, double b) { return std::fabs(a) < std::fabs(b); }));
  for (size_t k = 0; k < one.size(); ++k) {
    EXPECT_NEAR(small[k], one[k], 1e-6 * largest) << k;
    EXPECT_NEAR(large[k], one[k], 1e-6 * largest) << k;
  }
}

}  // namespace
