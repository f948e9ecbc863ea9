// Levels of white noise: in a reading, and in what drives a rig.
#include <algorithm>
#include <cmath>

#include "../band/band.hpp"
#include "host_sim/records/median.hpp"

namespace diagnosis::runs {

double white_noise_sum(const Vec& y) {
  const Index n = y.size() - 3;
  if (n < 1) return 0;
  return (y.tail(n) - 3 * y.segment(2, n) + 3 * y.segment(1, n) - y.head(n)).squaredNorm() / 20;
}

double noise_level(const Vec& f) {
  if (f.size() == 0 || f.cwiseAbs().maxCoeff() == 0) return 0;
  const size_t n = fast_length(static_cast<size_t>(f.size()));
  const Vec power = Fourier(n).forward(tapered(f.head(static_cast<Index>(n)))).cwiseAbs2() / static_cast<double>(n);
  const double top = host_sim::median({power.data() + power.size() * 2 / 3, power.data() + power.size() * 4 / 5});
  return std::sqrt(top / kMedianOfSpread);
}

Vec noise_along_force(const Prepared& p, size_t dof) {
  if (dof < p.noise_in_blows.size() && p.noise_in_blows[dof].size()) return p.noise_in_blows[dof];
  return Vec::Constant(p.force[dof].size(), noise_level(p.force[dof]));
}

double noise_of_force(const Prepared& p, size_t dof) {
  return p.force[dof].size() ? noise_along_force(p, dof).maxCoeff() : 0;
}

}  // namespace diagnosis::runs
