// The second way into the plant: simulation under a record's measured force.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "host_sim/plant/instruments/sensors.hpp"
#include "host_sim/plant/instruments/shaker.hpp"
#include "host_sim/plant/motion/fitted_start.hpp"
#include "host_sim/plant/plant_error.hpp"
#include "tests/plant/rigs.hpp"

namespace {

using host_sim::Quantity;
using plant_test::oscillator;

double nrmse_percent(const host_sim::Record& reference, size_t from, const host_sim::Record& run, Quantity quantity,
                     int dof) {
  const auto& a = reference.find(quantity, dof)->values;
  const auto& b = run.find(quantity, dof)->values;
  double error = 0.0, square = 0.0;
  for (size_t k = 0; k < b.size(); ++k) {
    error += (a[from + k] - b[k]) * (a[from + k] - b[k]);
    square += a[from + k] * a[from + k];
  }
  return 100.0 * std::sqrt(error / square);
}

// The paper's random case, started in mid-motion. Force interpolation is good to 5e-7 (signal_test), the state's
// velocity is measured: the runs differ by what a tolerance of 1e-6 leaves, and by the samples where friction jumps.
TEST(FreeRun, RepeatsASimulationFromTheMiddle) {
  const auto scenario = host_sim::load_scenario("paper_3dof_random");
  const auto record = host_sim::simulate_level(scenario, 1, 3);
  const auto run =
      host_sim::free_run(scenario.plant, record, 7000, host_sim::measured_state(scenario.plant, record, 7000), 10000);
  EXPECT_DOUBLE_EQ(run.start_s, record.start_s + 7.0);
  for (int dof = 1; dof <= 3; ++dof) {
    EXPECT_LT(nrmse_percent(record, 7000, run, Quantity::kDisplacement, dof), 1e-3);
    EXPECT_LT(nrmse_percent(record, 7000, run, Quantity::kVelocity, dof), 1e-3);
    EXPECT_LT(nrmse_percent(record, 7000, run, Quantity::kAcceleration, dof), 1e-1);
  }
}

// A body of 2 kg under 4 N for two seconds: x = t^2 + 3 t + 1 whatever the sampling.
TEST(FreeRun, ConstantForceGivesAParabola) {
  host_sim::Record record;
  record.sample_period_s = 0.01;
  record.channels.push_back({"force_1_N", Quantity::kForce, 1, std::vector<double>(201, 4.0)});
  const auto run = host_sim::free_run(oscillator(2.0, 0.0), record, 0, {{1.0}, {3.0}}, 201);
  for (size_t k = 0; k < 201; ++k) {
    const double t = 0.01 * static_cast<double>(k);
    EXPECT_NEAR(run.find(Quantity::kDisplacement, 1)->values[k], t * t + 3.0 * t + 1.0, 1e-9);
    EXPECT_NEAR(run.find(Quantity::kAcceleration, 1)->values[k], 2.0, 1e-12);
  }
}

// On a base that accelerates with 3 m/s^2 a mass of 2 kg hangs back by 2 * 3 / 800 m in its spring: it goes with the base.
TEST(FreeRun, ABaseWithAccelerationsAloneCarriesTheRig) {
  rig_file::RigModel rig = oscillator(2.0, 800.0, 0.0, 0.0, rig_file::kBase);
  host_sim::Record record;
  record.sample_period_s = 0.01;
  for (int dof : {1, rig_file::kBase})
    record.channels.push_back({"", Quantity::kAcceleration, dof, std::vector<double>(201, 3.0)});
  const auto run = host_sim::free_run(rig, record, 1, {{-0.0075}, {0.0}}, 200);
  EXPECT_DOUBLE_EQ(run.start_s, 0.01);
  for (size_t k = 0; k < 200; ++k) {
    EXPECT_NEAR(run.find(Quantity::kDisplacement, 1)->values[k], -0.0075, 1e-12);
    EXPECT_NEAR(run.find(Quantity::kAcceleration, 1)->values[k], 3.0, 1e-9);
  }
  rig.links.push_back(rig.links[0]);
  rig.links[1].b = rig_file::kGround;  // where that is, accelerations do not say
  EXPECT_THROW(host_sim::free_run(rig, record, 0, {{0.0}, {0.0}}, 200), host_sim::PlantError);
}

// Without a force channel there is no force: x = cos 10 t. drifting_viscous counts from the record's first sample: c_t
// t with c_t = 2 from sample 100 (1 s) on decays by exp(-(t^2 - 1)) (m = 1, k = 0).
TEST(FreeRun, NoForceChannelIsNoForceAndTimeIsTheRecords) {
  host_sim::Record record;
  record.sample_period_s = 0.01;
  record.channels.push_back({"displacement_1_m", Quantity::kDisplacement, 1, std::vector<double>(201, 0.0)});
  const auto swing = host_sim::free_run(oscillator(1.0, 100.0), record, 0, {{1.0}, {0.0}}, 201);
  EXPECT_NEAR(swing.find(Quantity::kDisplacement, 1)->values[200], std::cos(20.0), 1e-4);
  rig_file::RigModel drifting = oscillator(1.0, 0.0);
  drifting.links[0].effects.push_back(plant_test::effect("drifting_viscous", 2.0));
  const auto late = host_sim::free_run(drifting, record, 100, {{0.0}, {1.0}}, 101);
  EXPECT_NEAR(late.find(Quantity::kVelocity, 1)->values[100], std::exp(-3.0), 1e-5);
}

// A base that is known by its velocity alone: v = cos(10 t) means x = sin(10 t) / 10. A stiff damper makes the body
// follow.
TEST(FreeRun, BaseMotionFromItsVelocity) {
  host_sim::Record by_velocity, by_displacement;
  by_velocity.sample_period_s = by_displacement.sample_period_s = 1e-3;
  std::vector<double> v, x;
  for (int k = 0; k < 2001; ++k) {
    v.push_back(std::cos(0.01 * k));
    x.push_back(0.1 * std::sin(0.01 * k));
  }
  by_velocity.channels.push_back({"velocity_base_m_s", Quantity::kVelocity, rig_file::kBase, v});
  by_displacement.channels.push_back({"displacement_base_m", Quantity::kDisplacement, rig_file::kBase, x});
  const auto rig = oscillator(1.0, 400.0, 40.0, 0.0, rig_file::kBase);
  const auto a = host_sim::free_run(rig, by_velocity, 0, {{0.0}, {1.0}}, 2001);
  const auto b = host_sim::free_run(rig, by_displacement, 0, {{0.0}, {1.0}}, 2001);
  for (size_t k = 0; k < 2001; k += 100)
    EXPECT_NEAR(a.find(Quantity::kDisplacement, 1)->values[k], b.find(Quantity::kDisplacement, 1)->values[k], 1e-5);
  EXPECT_THROW(host_sim::free_run(rig, host_sim::Record{}, 0, {}, 0), host_sim::PlantError);
}

TEST(FreeRun, ASampleRangeBeyondTheRecordIsRefused) {
  host_sim::Record record;
  record.sample_period_s = 1e-3;
  record.channels.push_back({"force_1_N", Quantity::kForce, 1, std::vector<double>(10, 0.0)});
  EXPECT_THROW(host_sim::free_run(oscillator(1.0, 1.0), record, 5, {}, 6), host_sim::PlantError);
}

// A negative damper blows up: told, not returned as numbers.
TEST(FreeRun, ABlowUpIsAnError) {
  host_sim::Record record;
  record.sample_period_s = 1e-3;
  record.channels.push_back({"force_1_N", Quantity::kForce, 1, std::vector<double>(20000, 1.0)});
  EXPECT_THROW(host_sim::free_run(oscillator(1.0, 100.0, -500.0), record, 0, {{1e-3}, {0.0}}, 20000),
               host_sim::PlantError);
}

// Noise in the measured force must not stall the integrator: 20 s of 3 DOFs at 1 kHz, 5 % noise, with friction. The
// target is 0.3 s on one core; a busy test machine gets ten times that.
TEST(FreeRun, IsQuickUnderANoisyForce) {
  const auto scenario = host_sim::load_scenario("paper_3dof_random_noise");
  const auto levels = host_sim::measure(scenario, 1);
  const std::clock_t start = std::clock();
  const auto run = host_sim::free_run(scenario.plant, levels.measured[0], 2000,
                                      host_sim::measured_state(scenario.plant, levels.measured[0], 2000), 20000);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;  // of this process alone
  RecordProperty("milliseconds", static_cast<int>(1000 * seconds));
  EXPECT_LT(seconds, 3.0);
  // 5 % white force noise, little of it in the resonances' band: displacement within 5 % of the noise-free one
  EXPECT_LT(nrmse_percent(levels.truth[0], 2000, run, Quantity::kDisplacement, 1), 5.0);
}

// x'' = 1000 x^3 from 1 m: x' grows as sqrt(500) x^2, and x is without bound after 1 / sqrt(500) = 45 ms or a little more. Two samples of
// 100 ms, and the same with a limit of five steps a sample: the user reads of the motion, not of the solver's functions.
TEST(FreeRun, SaysWhyItStoppedInItsOwnWords) {
  auto rig = oscillator(1.0, 0.0);
  rig.links[0].effects.push_back(plant_test::effect("cubic_stiffness", -1000.0));
  host_sim::Record record;
  record.file = "made.csv", record.sample_period_s = 0.1;
  record.channels.push_back({"displacement_1_m", Quantity::kDisplacement, 1, {1.0, 1.0, 1.0}});
  record.channels.push_back({"force_1_N", Quantity::kForce, 1, {0.0, 0.0, 0.0}});
  for (const long most_steps : {200000L, 5L}) {
    host_sim::FreeRunOptions options;
    options.integrator.most_steps_per_sample = most_steps;
    try {
      host_sim::free_run(rig, record, 0, {{1.0}, {0.0}}, 3, options);
      ADD_FAILURE() << "simulated";
    } catch (const host_sim::PlantError& error) {
      const std::string said = error.what();
      EXPECT_EQ(said.rfind("simulation stopped at t = 0.0", 0), 0u) << said;
      for (const char* foreign : {"ERK", "ARK", "tout", "mxstep", "tolerance factor", "At t ="})
        EXPECT_EQ(said.find(foreign), std::string::npos) << said;
      EXPECT_NE(said.find(most_steps == 5 ? "one sample takes more than 5 steps" : "?)"), std::string::npos) << said;
    }
  }
}

}  // namespace
