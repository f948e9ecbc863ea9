#include "tests/closed_loop/closed_loop_rig.hpp"

#include <algorithm>
#include <cmath>

namespace closed_loop {
namespace {

constexpr double kLag_s = 1e-3;
constexpr double kFullScaleCode = 8388607.0;

}  // namespace

void ClosedLoopRig::AmplifierForce::next_period(double command_N) {
  begin_s += period_s;
  force_N[0] = at_end;
  const double kept = std::exp(-period_s / kParts / kLag_s);
  for (int i = 1; i <= kParts; ++i) {
    lag[0] = command_N + (lag[0] - command_N) * kept;
    lag[1] = lag[0] + (lag[1] - lag[0]) * kept;
    force_N[i] = lag[1];
  }
  at_end = force_N[kParts];
}

double ClosedLoopRig::AmplifierForce::value(double t_s) const {
  const double place = std::clamp((t_s - begin_s) / period_s * kParts, 0.0, static_cast<double>(kParts));
  const int part = std::min(static_cast<int>(place), kParts - 1);
  return force_N[part] + (place - part) * (force_N[part + 1] - force_N[part]);
}

ClosedLoopRig::ClosedLoopRig(const RigSettings& settings)
    : settings_(settings),
      equations_(settings.plant),
      force_(std::make_shared<AmplifierForce>()),
      random_(settings.seed) {
  force_->period_s = settings.sample_period_s;
  force_->begin_s = -settings.sample_period_s;
  force_->full_scale_N = settings.full_scale_force_N;
  excitation_.force_N.resize(equations_.masses());
  excitation_.force_N[static_cast<size_t>(settings.driven_dof - 1)] = force_;
  host_sim::IntegratorOptions options;
  options.relative_tolerance = 1e-9;
  integrator_ = std::make_unique<host_sim::Integrator>(equations_, excitation_, options, 0.0, settings.sample_period_s,
                                                       equations_.initial_state({}, {}, {}));
  for (size_t dof = 1; dof <= equations_.masses(); ++dof) {
    const std::pair<firmware::Quantity, double> ranges[] = {
        {firmware::Quantity::kForce, settings.full_scale_force_N},
        {firmware::Quantity::kDisplacement, settings.displacement_range_m},
        {firmware::Quantity::kVelocity, settings.velocity_range_m_s},
        {firmware::Quantity::kAcceleration, settings.acceleration_range_m_s2}};
    for (const auto& [quantity, range] : ranges) {
      if (quantity == firmware::Quantity::kForce && static_cast<int>(dof) != settings.driven_dof) continue;
      rig_file::ChannelCalibration calibration;
      calibration.quantity = quantity;
      calibration.dof = static_cast<int>(dof);
      calibration.unit_per_code = range / kFullScaleCode;
      calibrations_.push_back(calibration);
    }
  }
}

void ClosedLoopRig::advance() {
  const double command = relay.active() ? drive_q31_ / 2147483648.0 * settings_.full_scale_force_N : 0.0;
  force_->next_period(command);
  ++sequence_;
  integrator_->advance_to(sequence_ * settings_.sample_period_s);
  now_ns_ = static_cast<uint64_t>(std::llround(sequence_ * settings_.sample_period_s * 1e9));
  digitise();
  ready_ = true;
}

void ClosedLoopRig::digitise() {
  std::normal_distribution<double> noise(0.0, 1.0);
  const std::vector<double> derivative = integrator_->derivative();
  const size_t masses = equations_.masses();
  sample_.sequence = sequence_;
  sample_.time_ns = now_ns_;
  for (const rig_file::ChannelCalibration& calibration : calibrations_) {
    const auto dof = static_cast<size_t>(calibration.dof - 1);
    double value = force_->at_end;
    if (calibration.quantity == firmware::Quantity::kDisplacement) value = integrator_->state()[dof];
    if (calibration.quantity == firmware::Quantity::kVelocity) value = integrator_->state()[masses + dof];
    if (calibration.quantity == firmware::Quantity::kAcceleration) value = derivative[masses + dof];
    double code = value / calibration.unit_per_code;
    if (settings_.noise_codes > 0.0) code += settings_.noise_codes * noise(random_);
    auto rounded = static_cast<int32_t>(std::lround(std::clamp(code, -kFullScaleCode, kFullScaleCode)));
    const bool late =
        calibration.dof == settings_.late_displacement_dof && calibration.quantity == firmware::Quantity::kDisplacement;
    if (late) std::swap(rounded, held_code_);
    sample_.code[dof][static_cast<int>(calibration.quantity)] = rounded;
  }
}

hal::SampleResult ClosedLoopRig::read(firmware::RawSample& sample) {
  if (!ready_) return hal::SampleResult::kNone;
  sample = sample_;
  ready_ = false;
  return hal::SampleResult::kSample;
}

}  // namespace closed_loop
