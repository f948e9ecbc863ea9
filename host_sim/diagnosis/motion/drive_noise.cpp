#include "drive_noise.hpp"

#include <algorithm>

namespace diagnosis::runs {

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

bool drives_have_noise(const std::vector<Prepared>& records) {
  return std::any_of(records.begin(), records.end(), [](const Prepared& p) {
    for (size_t d = 0; d < p.force.size(); ++d)
      if (noise_of_force(p, d) > 0) return true;
    return std::any_of(p.base.reading.begin(), p.base.reading.end(), [](const Vec& y) { return noise_level(y) > 0; });
  });
}

}  // namespace diagnosis::runs
