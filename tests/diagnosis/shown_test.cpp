// What records can show of a fitted shape.
#include "host_sim/diagnosis/choice/shown.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
