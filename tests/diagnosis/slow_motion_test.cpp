// Motion slower than integrated channels tell, from the balance of a model.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/diagnosis/record/sharpen.hpp"
#include "host_sim/diagnosis/search/candidates.hpp"

namespace diagnosis {
namespace {

constexpr double kFast = 62.83185307179586, kSlow = 3.141592653589793;  // 10 Hz, 0.5 Hz: the rows begin at 1 Hz
constexpr double kMass = 1, kStiffness = 1e4, kViscous = 20;

// Force of m x'' + c x' + k x for x = amplitude cos(omega t).
double force_for(double amplitude, double omega, double t_s) {
  return amplitude *
         ((kStiffness - kMass * omega * omega) * std::cos(omega * t_s) - kViscous * omega * std::sin(omega * t_s));
}

// 20 s at 1 kHz of x = 0.5 mm + 0.2 mm cos(slow) + 1 mm cos(fast), seen by an accelerometer: 2 mm/s^2 of 4 m/s^2 are slow.
struct Plant {
  rig_file::RigModel rig;
  host_sim::Record record;
  explicit Plant(double stiffness) {
    rig_file::Dof dof;
    dof.mass_kg.value = kMass;
    rig.dofs = {dof};
    rig_file::Link link;
    link.a = 1;
    link.stiffness_N_m.value = stiffness, link.viscous_N_s_m.value = kViscous;
    rig.links = {link};
    record.sample_period_s = 1e-3;
    host_sim::Channel force{"force_1_N", host_sim::Quantity::kForce, 1, {}};
    host_sim::Channel acceleration{"acceleration_1_m_s2", host_sim::Quantity::kAcceleration, 1, {}};
    std::mt19937_64 dice(5);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 20000; ++i) {
      const double t_s = 1e-3 * i;
      force.values.push_back(5e-4 * kStiffness + force_for(2e-4, kSlow, t_s) + force_for(1e-3, kFast, t_s) +
                             1e-6 * normal(dice));
      acceleration.values.push_back(-1e-3 * kFast * kFast * std::cos(kFast * t_s) -
                                    2e-4 * kSlow * kSlow * std::cos(kSlow * t_s) + 1e-6 * normal(dice));
    }
    record.channels = {force, acceleration};
  }
  FusedRecord fused() const {
    FusedRecord f = read_record(rig, record, 0.098);
    estimate_noise(f);
    fuse(f);
    return f;
  }
};

// The model of the rig file, settled on the records.
std::vector<ActiveTerm> model_of(const System& system, const std::vector<FusedRecord>& records) {
  Rows rows(system, records);
  std::vector<ActiveTerm> model = base_model(rows);
  settle(rows, model, 2);
  return model;
}

// At t = 10 s both cosines are 1: 0.5 + 0.2 + 1 mm; half a fast period later 0.5 + 0.2 cos(slow 0.05 s) - 1 mm. What is slow
// must be right within a hundredth (7 um), its rate within a twentieth.
TEST(SlowMotion, IsWhatBalancesTheForce) {
  const Plant plant(kStiffness);
  const System system = make_system(plant.rig);
  std::vector<FusedRecord> records{plant.fused()};
  const std::vector<ActiveTerm> model = model_of(system, records);
  EXPECT_LT(std::abs(records[0].motion[0].smooth_x.segment(9000, 2000).mean()),
            1e-5);  // of 0.5 mm, which no acceleration tells
  add_slow_motion(records[0], system, model, 0);
  const DofMotion& m = records[0].motion[0];
  EXPECT_NEAR(m.smooth_x[10000], 1.7e-3, 7e-6);
  EXPECT_NEAR(m.smooth_x[10050], -0.5e-3 + 2e-4 * std::cos(kSlow * 0.05), 7e-6);
  EXPECT_NEAR(m.smooth_v[10500], -2e-4 * kSlow,
              0.05 * 2e-4 * kSlow);  // a quarter of the slow period on: fast velocity 0, slow at its peak
  const Series once = m.smooth_x;
  add_slow_motion(records[0], system, model, 0);  // it takes the place of what was there
  EXPECT_LT((records[0].motion[0].smooth_x - once).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SlowMotion, OfARigThatFloatsIsLeftAlone) {
  const Plant plant(0);
  const System system = make_system(plant.rig);
  std::vector<FusedRecord> records{plant.fused()};
  const Series before = records[0].motion[0].smooth_x;
  add_slow_motion(records[0], system, model_of(system, records), 0);
  EXPECT_EQ(records[0].motion[0].smooth_x, before);
}

}  // namespace
}  // namespace diagnosis
