#include "drive_noise.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

// Of a force's rms. Load cells and commanded currents have a few percent; a channel a quarter of which is noise is no
// instrument that anybody has calibrated for its mean.
constexpr double kMuchNoise = 0.25;
// Of its noise. A servo's torque that was recorded beside its command was off by 0.11 of its noise, more at one level and less at
// another.
constexpr double kLasting = 0.125;
constexpr double kIdle =
    0.5;  // of its noise: a load cell that nothing pushes shows no more, and has nothing to be off by

}  // namespace

void DriveNoise::disturb(const Vec& sigma, Vec& y) {
  for (Index i = 0; i < y.size(); ++i) y[i] += sigma[i] * normal_(random_);
}

Prepared DriveNoise::added_to(const Prepared& record) {
  Prepared noisy = record;
  for (size_t d = 0; d < noisy.force.size(); ++d) disturb(noise_along_force(record, d), noisy.force[d]);
  for (Vec& b : noisy.base.reading) disturb(Vec::Constant(b.size(), noise_level(b)), b);
  renew_base(noisy);
  return noisy;
}

// Its noise is that of the samples as they were read: thinning has averaged it.
double lasting_error_of_force(const Prepared& record, size_t dof) {
  const Vec& force = record.force[dof];
  if (force.size() == 0) return 0;
  const double left_noise = noise_of_force(record, dof), about_mean = rms_about_mean(force);
  if (about_mean * about_mean < (1 + kIdle * kIdle) * left_noise * left_noise) return 0;
  const double noise = left_noise * std::sqrt(record.step_s / record.read_every_s);
  const double rms = std::sqrt(force.squaredNorm() / static_cast<double>(force.size()));
  return noise > kMuchNoise * rms ? kLasting * noise : 0;
}

bool drives_are_much_noise(const std::vector<Prepared>& records) {
  return std::any_of(records.begin(), records.end(), [](const Prepared& p) {
    for (size_t d = 0; d < p.force.size(); ++d)
      if (lasting_error_of_force(p, d) > 0) return true;
    return false;
  });
}

bool drives_have_noise(const std::vector<Prepared>& records) {
  return std::any_of(records.begin(), records.end(), [](const Prepared& p) {
    for (size_t d = 0; d < p.force.size(); ++d)
      if (noise_of_force(p, d) > 0) return true;
    return std::any_of(p.base.reading.begin(), p.base.reading.end(), [](const Vec& y) { return noise_level(y) > 0; });
  });
}

}  // namespace diagnosis::runs
