#include "drive_noise.hpp"

#include <algorithm>

namespace diagnosis::runs {

void DriveNoise::disturb(Vec& y) {
  const double sigma = noise_level(y);
  for (double& value : y) value += sigma * normal_(random_);
}

Prepared DriveNoise::added_to(const Prepared& record) {
  Prepared noisy = record;
  for (Vec& f : noisy.force) disturb(f);
  for (Vec& b : noisy.base.reading) disturb(b);
  renew_base(noisy);
  return noisy;
}

bool drives_have_noise(const std::vector<Prepared>& records) {
  const auto noisy = [](const Vec& y) { return noise_level(y) > 0; };
  return std::any_of(records.begin(), records.end(), [&](const Prepared& p) {
    return std::any_of(p.force.begin(), p.force.end(), noisy) ||
           std::any_of(p.base.reading.begin(), p.base.reading.end(), noisy);
  });
}

}  // namespace diagnosis::runs
