// What records can show of a fitted shape.
#include "host_sim/diagnosis/doubts/shown.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using namespace diagnosis;
using namespace diagnosis::runs;

// A damper moved by hand at 2 Hz for 20 s, 100 Hz: periods of 0.5 s.
host_sim::Record record_at_2_Hz() {
  host_sim::Record r;
  r.file = "damper.csv", r.sample_period_s = 0.01;
  std::vector<double> x, f;
  const double w = 4 * 3.14159265358979;
  for (int i = 0; i < 2000; ++i) {
    const double t = i * r.sample_period_s;
    x.push_back(0.02 * std::sin(w * t)), f.push_back(500 * 0.02 * w * std::cos(w * t));
  }
  r.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, x},
                {"force_1_N", host_sim::Quantity::kForce, 1, f}};
  return r;
}

// Within its first 1.5 s a motion of 2 Hz shows three dampings.
TEST(Shown, ADriftTakesLongerThanThreePeriods) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  const System system = make_system(rig);
  const std::vector<Prepared> records = prepare_all(rig, {record_at_2_Hz()}, {});
  const Task task{system, records, 1};
  const auto shows = [&](double drift_time_s) {
    ModelTerm t;
    t.term = on_link(Kind::kDriftingViscous, 0, drift_time_s), t.value = 100;
    return shown(task, t);
  };
  EXPECT_FALSE(shows(0.1));
  EXPECT_FALSE(shows(1.4));
  EXPECT_TRUE(shows(1.6));
  EXPECT_TRUE(shows(10));
  EXPECT_TRUE(shows(0)) << "a drift without end";
  EXPECT_TRUE(shows(kAcrossRecords)) << "a drift from record to record";
}

// At 2 Hz and 20 mm the link starts from a reversal at 3.2 m/s^2 (2.2 rms): within 10 ms it moves by 0.11 mm. Bristles of 0.05 mm
// bend within a sample. Beside a mass that is a filter's doing as well as theirs; of a force that is measured against the motion
// a filter's lag is the force's delay.
TEST(Shown, BristlesThatBendWithinASample) {
  for (const double mass_kg : {0.0, 1.0}) {
    rig_file::RigModel rig;
    rig.dofs.resize(1), rig.links.resize(1);
    rig.dofs[0].mass_kg.value = mass_kg;
    rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
    const System system = make_system(rig);
    const std::vector<Prepared> records = prepare_all(rig, {record_at_2_Hz()}, {});
    const Task task{system, records, 1};
    ModelTerm t;
    t.term = on_link(Kind::kPresliding, 0, 5e-5), t.value = 50;
    EXPECT_EQ(shown(task, t), mass_kg == 0) << mass_kg << " kg";
    t.term.shape = 5e-4;
    EXPECT_TRUE(shown(task, t)) << mass_kg << " kg";
  }
}

// A damper on a slow crank, 50 samples a second: friction of 50 N on bristles of 0.06 mm, which bend within a sample of the turn (0.11 mm), an
// offset of 140 N, noise of 2 N. Beyond that sample bristles are friction, which the rig file has; a spring along the way, which takes a
// third of what is left beside the offset, is not what is missing.
TEST(Shown, ADampersBristlesThatBendWithinASampleAreItsFriction) {
  host_sim::Record r;
  r.file = "crank.csv", r.sample_period_s = 0.02;
  std::vector<double> x, f;
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 2);
  const double w = 6.7, length = 6e-5;
  double bend = 0, before = 0;
  for (int i = 0; i < 1400 * 50; ++i) {  // 50 steps a sample
    const double t = i * r.sample_period_s / 50, way = 0.012 * std::sin(w * t), step = way - before;
    bend += (step - std::abs(step) * bend) / length, before = way;
    if (i % 50 == 0) x.push_back(way), f.push_back(600 * 0.012 * w * std::cos(w * t) + 50 * bend + 140 + noise(random));
  }
  r.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, x},
                {"force_1_N", host_sim::Quantity::kForce, 1, f}};
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  const Diagnosis d = diagnose(rig, {r}, {});
  EXPECT_TRUE(d.names("force_offset", "link 1-0")) << two_masses::said(d);
  EXPECT_EQ(d.causes.size(), 1u) << two_masses::said(d);
  EXPECT_TRUE(d.ambiguous_with.empty()) << two_masses::said(d);
  EXPECT_NEAR(two_masses::value_of(d.extended, "viscous[1-0]"), 600, 20);
  EXPECT_NEAR(two_masses::value_of(d.extended, "coulomb[1-0]"), 50, 2);
}

}  // namespace
