// A simulated rig that answers the controller's drive: host_sim's plant behind the hal interfaces, one sample period at
// a time.
//
//   drive command -> relay -> amplifier (two lags of 1 ms) -> force on one DOF -> plant -> converter codes
//
// The drive written after sample k acts from sample k to sample k + 1. Time is the rig's own: it moves in advance()
// only.
#pragma once
#include <memory>
#include <random>
#include <vector>

#include "hal/fake/fake_devices.hpp"
#include "hal/interface/clock.hpp"
#include "hal/interface/drive_output.hpp"
#include "hal/interface/sample_source.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "host_sim/plant/motion/integrator.hpp"

namespace closed_loop {

struct RigSettings {
  rig_file::RigModel plant;  // all numbers
  double sample_period_s = 1e-3;
  double full_scale_force_N = 100.0;
  int driven_dof = 1;
  double displacement_range_m = 0.1, velocity_range_m_s = 10.0, acceleration_range_m_s2 = 1000.0;
  double noise_codes = 0.0;  // rms, white, on every channel
  uint32_t seed = 1;
  int late_displacement_dof = 0;  // its displacement shows the motion of one sample period ago; 0: none
};

class ClosedLoopRig final : public hal::SampleSource, public hal::DriveOutput, public hal::MonotonicClock {
 public:
  explicit ClosedLoopRig(const RigSettings& settings);

  void advance();  // one sample period; then one sample is ready

  hal::SampleResult read(firmware::RawSample& sample) override;
  bool write(int32_t drive_q31) override {
    drive_q31_ = drive_q31;
    return true;
  }
  uint64_t now_ns() override { return now_ns_; }

  const std::vector<rig_file::ChannelCalibration>& calibrations() const { return calibrations_; }
  int32_t drive_q31() const { return drive_q31_; }
  double force_N() const { return force_->at_end; }
  double displacement_m(int dof) const { return integrator_->state()[static_cast<size_t>(dof - 1)]; }
  hal::FakeOutput relay;

 private:
  // The force within one sample period, at `kParts` + 1 points.
  struct AmplifierForce final : host_sim::Signal {
    static constexpr int kParts = 32;
    double begin_s = 0.0, period_s = 1e-3, at_end = 0.0, lag[2] = {};
    double force_N[kParts + 1] = {};
    double full_scale_N = 1.0;
    void next_period(double command_N);
    double value(double t_s) const override;
    host_sim::Motion motion(double t_s) const override { return {value(t_s), 0.0, 0.0}; }
    double peak() const override { return full_scale_N; }
  };
  void digitise();

  RigSettings settings_;
  host_sim::Equations equations_;
  std::shared_ptr<AmplifierForce> force_;
  host_sim::Excitation excitation_;
  std::unique_ptr<host_sim::Integrator> integrator_;
  std::vector<rig_file::ChannelCalibration> calibrations_;
  std::mt19937 random_;
  int32_t drive_q31_ = 0;
  uint64_t now_ns_ = 0;
  uint32_t sequence_ = 0;
  bool ready_ = false;
  firmware::RawSample sample_;
  int32_t held_code_ = 0;
};

}  // namespace closed_loop
