// Bristles where a run begins.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/diagnosis/simulate/simulator.hpp"
#include "two_masses.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kLength_m = 1e-3;

// 6 mm one way, half a length back, and rest: bent all the way at the turn, and 1 - 2 (1 - exp(-1/2)) = 0.2131 from then on.
struct Drive {
  rig_file::RigModel rig;
  std::vector<Prepared> records;
  Model model;
  Drive() {
    rig.dofs.resize(1), rig.links.resize(1);
    rig.dofs[0].mass_kg.value = 2, rig.links[0].a = 1;
    host_sim::Record record;
    record.file = "drive.csv", record.sample_period_s = 0.01;
    record.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, {}},
                       {"displacement_1_m", host_sim::Quantity::kDisplacement, 1, {}}};
    for (int k = 0; k < 800; ++k) {
      const double there = 6e-3 * std::min(k, 300) / 300.0,
                   back = 0.5 * kLength_m * std::min(std::max(k - 400, 0), 100) / 100.0;
      record.channels[0].values.push_back(std::sin(0.1 * k));
      record.channels[1].values.push_back(there - back);
    }
    records = prepare_all(rig, {record}, {});
    ModelTerm mass, bristles;
    mass.term = on_dof(Kind::kMass, 0), mass.value = 2;
    bristles.term = on_link(Kind::kPresliding, 0, kLength_m), bristles.value = 10;
    model = {mass, bristles};
  }
};

TEST(BentBristles, AreWhatTheWayBeforeHasMadeOfThem) {
  const Drive drive;
  const System system = make_system(drive.rig);
  const Simulator simulator(system, drive.model, drive.records[0]);
  const double by = drive.records[0].step_s / 0.01;
  const auto bent = [&](double sample) { return simulator.guessed_state(static_cast<Index>(sample / by))[2]; };
  EXPECT_NEAR(bent(350), 1, 0.02);
  EXPECT_NEAR(bent(450), 1 - 2 * (1 - std::exp(-0.25)), 0.03);
  EXPECT_NEAR(bent(700), 0.2131, 0.03);  // at rest: a run that begins there took it for 1
}

}  // namespace
}  // namespace diagnosis::runs
