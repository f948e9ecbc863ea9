// Windows in which nothing but filters that settle has taken samples: their numbers are those of the window before, and say so.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "firmware/estimator_core.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/toml/rig_reader.hpp"

namespace {

using firmware::EstimateStatus;
using firmware::Quantity;

constexpr double kRate_Hz = 1000.0, kMass_kg = 1.0, kStiffness_N_m = 16000.0, kDamper_N_s_m = 10.0, kUnit = 1e-5;

// A rig with an accelerometer alone, shaken at two frequencies at once.
class SettlingWindows : public testing::Test {
 protected:
  SettlingWindows() {
    const rig_file::RigModel model = rig_file::parse_rig(
        "schema = \"rig/1\"\n[[dof]]\nmass_kg = 1.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = \"estimate\"\n"
        "viscous_N_s_m = \"estimate\"\n",
        "rig.toml");
    rig_file::ChannelCalibration force, acceleration;
    force.quantity = Quantity::kForce, force.unit_per_code = kUnit;
    acceleration.quantity = Quantity::kAcceleration, acceleration.unit_per_code = kUnit;
    configuration_ = rig_file::compile_rig(model, 1.0 / kRate_Hz, {force, acceleration});
    core_ = std::make_unique<firmware::EstimatorCore>(configuration_);
    core_->begin_level();
  }
  void push(int count) {
    for (int i = 0; i < count; ++i, ++sequence_) {
      firmware::RawSample sample;
      sample.sequence = sequence_;
      double force_N = 0.0, acceleration = 0.0;
      for (const double frequency_Hz : {17.3, 23.9}) {
        const double w = 2.0 * M_PI * frequency_Hz, x = 1e-3 * std::sin(w * sequence_ / kRate_Hz),
                     v = 1e-3 * w * std::cos(w * sequence_ / kRate_Hz);
        acceleration -= w * w * x;
        force_N += kStiffness_N_m * x + kDamper_N_s_m * v - kMass_kg * w * w * x;
      }
      state_ = 1664525u * state_ + 1013904223u;
      sample.code[0][0] = static_cast<int32_t>(std::lround(force_N / kUnit));
      sample.code[0][3] = static_cast<int32_t>(std::lround(acceleration / kUnit)) + static_cast<int32_t>(state_ >> 26);
      core_->push(sample);
    }
  }
  void expect(EstimateStatus status) {
    const firmware::Estimates& estimates = core_->solve();
    for (int k = 0; k < 2; ++k) EXPECT_EQ(estimates.parameters[k].status, status) << k;
    EXPECT_NEAR(rig_file::to_double(estimates.parameters[0].value), kStiffness_N_m, 0.002 * kStiffness_N_m);
  }
  firmware::CoreConfiguration configuration_;
  std::unique_ptr<firmware::EstimatorCore> core_;
  uint32_t sequence_ = 0, state_ = 1;
};

}  // namespace

TEST_F(SettlingWindows, BehindAGapNothingIsNew) {
  push(30000);
  expect(EstimateStatus::kValid);
  expect(EstimateStatus::kValid);  // asked twice: no sample has come that could tell more
  push(500);
  sequence_ += 3;
  push(200);
  expect(EstimateStatus::kValid);  // the 500 before the gap are new
  ASSERT_GT(core_->margin_samples(), 2000) << "no test";
  for (int window = 0; window < 3; ++window) {
    push(500);
    expect(EstimateStatus::kStale);
  }
  push(1500);
  expect(EstimateStatus::kValid);
}

TEST_F(SettlingWindows, AFurtherLevelBeginsWithNothingNew) {
  push(30000);
  core_->end_level();
  expect(EstimateStatus::kValid);
  core_->begin_level();
  push(500);
  expect(EstimateStatus::kStale);
  core_->end_level();  // what it leaves is the result of all levels
  expect(EstimateStatus::kValid);
}
