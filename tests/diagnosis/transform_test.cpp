// Spectra of a windowed motion of which only derivatives are measured.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/diagnosis/record/motion.hpp"

namespace diagnosis {
namespace {

constexpr double kOmega = 62.83185307179586;  // 10 Hz

// x = 1 mm cos(omega t + 0.3) for 20 s at 1 kHz, without noise; the sensors' zeros are off by `zero` of their peak.
host_sim::Record record_of(const std::string& sensors, double zero) {
  host_sim::Record record;
  record.sample_period_s = 1e-3;
  const auto add = [&](host_sim::Quantity quantity, const std::string& name, double peak, double phase) {
    host_sim::Channel c{name, quantity, 1, {}};
    for (int i = 0; i < 20000; ++i) c.values.push_back(peak * (std::cos(kOmega * 1e-3 * i + 0.3 + phase) + zero));
    record.channels.push_back(c);
  };
  const double quarter = 1.5707963267948966;
  if (sensors.find('x') != std::string::npos) add(host_sim::Quantity::kDisplacement, "displacement_1_m", 1e-3, 0);
  if (sensors.find('v') != std::string::npos)
    add(host_sim::Quantity::kVelocity, "velocity_1_m_s", 1e-3 * kOmega, quarter);
  if (sensors.find('a') != std::string::npos)
    add(host_sim::Quantity::kAcceleration, "acceleration_1_m_s2", 1e-3 * kOmega * kOmega, 2 * quarter);
  return record;
}

FusedRecord read(const std::string& sensors, double zero) {
  rig_file::RigModel rig;
  rig.dofs.emplace_back();
  return read_record(rig, record_of(sensors, zero), 0.098);
}

// (g x)' and (g x)'' from a velocity or an acceleration alone must be jw and -w^2 times the spectrum of g x, from 1 Hz to
// the end of the rows. The bound is in the mean square over time, relative to the motion's.
double disagreement(const std::string& sensors, size_t quantity, double zero) {
  const FusedRecord whole = read("x", 0), part = read(sensors, zero);
  double wrong = 0, all = 0;
  for (Eigen::Index i = part.first_bin; i <= part.last_bin; ++i) {
    const Complex truth = derivative(whole.omega(i), static_cast<int>(quantity)) * whole.spectra[0].z[0][i];
    wrong += std::norm(part.spectra[0].z[quantity][i] - truth), all += std::norm(truth);
  }
  return std::sqrt(wrong / all);
}

// 3 + 2 cos: 9 + 2 in the mean square, 2 of it from bin 1 on.
TEST(Transform, MeanSquareOfASpectrum) {
  const Fourier fourier(1000);
  Series s(1000);
  for (Eigen::Index i = 0; i < 1000; ++i) s[i] = 3 + 2 * std::cos(kOmega * 1e-3 * static_cast<double>(i));
  EXPECT_NEAR(mean_square(fourier.forward(s), 1000), 11, 1e-9);
  EXPECT_NEAR(mean_square(fourier.forward(s), 1000, 1), 2, 1e-9);
}

TEST(Transform, AVelocityAloneTellsTheWindowedMotion) { EXPECT_LT(disagreement("v", 1, 0), 1e-4); }
TEST(Transform, AnAccelerationAloneTellsTheWindowedMotion) { EXPECT_LT(disagreement("a", 2, 0), 0.01); }
TEST(Transform, VelocityAndAccelerationAgreeOnIt) { EXPECT_LT(disagreement("va", 2, 0), 1e-4); }
TEST(Transform, TheZeroOfASensorDoesNotMatter) {
  EXPECT_LT(disagreement("v", 1, 0.5), 1e-4);
  EXPECT_LT(disagreement("a", 2, 0.5), 0.01);
}

}  // namespace
}  // namespace diagnosis
