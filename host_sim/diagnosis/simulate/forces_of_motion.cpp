#include <algorithm>
#include <cmath>

#include "simulator.hpp"

// Forces that a motion takes: of a rig without masses, the answer itself.
namespace diagnosis::runs {

// Without masses the motion is given and the forces follow. Rates near zero have half a sign (slopes stay bounded).
void Simulator::forces_of_motion(const Mat& x, const Mat& v, const Mat& a, Mat& force, std::vector<Mat>& slopes) const {
  const Index n = nodes_, count = x.cols();
  force.setZero(n, count);
  slopes.assign(static_cast<size_t>(parameters_), Mat());
  for (Mat& m : slopes) m.setZero(n, count);
  for (Index node = 0; node < n; ++node) {  // a carriage that the rig file lacks
    force.row(node) += mass_[node] * a.row(node);
    for (const Index p : by_mass_[static_cast<size_t>(node)]) slopes[static_cast<size_t>(p)].row(node) += a.row(node);
  }
  const Guess& base = record_.guess.back();
  const auto end = [&](const Mat& m, const Vec& of_base, int i, Index k) {
    return i >= 0 ? m(i, k) : i == -2 && base.given ? of_base[k] : 0.0;
  };
  const auto elongation_of = [&](const Element& e, Index k) { return end(x, base.x, e.a, k) - end(x, base.x, e.b, k); };
  const auto rate_of = [&](const Element& e, Index k) { return end(v, base.v, e.a, k) - end(v, base.v, e.b, k); };
  for (const Element& e : elements_) {
    double z = 0, z_slope = 0, before = 0;
    for (Index k = 0; k < count; ++k) {
      const double u = elongation_of(e, k), w = rate_of(e, k);
      LawValue f;
      if (e.kind == Kind::kPresliding) {
        if (k == 0) z = w < 0 ? -1 : 1, before = u;
        const double way = u - before, sign = way < 0 ? -1 : 1, fade = std::exp(-std::abs(way) / e.shape);
        z_slope = z_slope * fade + (z - sign) * fade * std::abs(way) / e.shape;
        z = sign + (z - sign) * fade, before = u;
        double by_z = 1;
        f = bristles(w, z, e.shape, e.shape2, by_z);
        f.by_log_shape += by_z * z_slope;
      } else if (e.kind == Kind::kCoulomb || e.kind == Kind::kMissingCoulomb || e.kind == Kind::kStribeck) {
        const double spread = k + 1 < count && k > 0 ? 0.25 * std::abs(rate_of(e, k + 1) - rate_of(e, k - 1)) : 0;
        const double sign = spread > 0 ? std::clamp(w / spread, -1.0, 1.0) : w < 0 ? -1.0 : 1.0;
        const double share = e.kind == Kind::kStribeck ? std::exp(-std::abs(w) / e.shape) : 1;
        f.force = sign * share, f.by_log_shape = e.kind == Kind::kStribeck ? sign * share * std::abs(w) / e.shape : 0;
      } else {
        f = law(e.kind, u, w, law_time(record_.time_s(k), e.shape, record_), e.shape, e.shape2);
      }
      for (int side = 0; side < 2; ++side) {
        const int node = side == 0 ? e.a : e.b;
        if (node < 0) continue;
        const double turn = side == 0 ? 1 : -1;
        force(node, k) += turn * e.value * f.force;
        if (e.by_value >= 0) slopes[static_cast<size_t>(e.by_value)](node, k) += turn * f.force;
        if (e.by_shape >= 0) slopes[static_cast<size_t>(e.by_shape)](node, k) += turn * e.value * f.by_log_shape;
        if (e.by_shape2 >= 0) slopes[static_cast<size_t>(e.by_shape2)](node, k) += turn * e.value * f.by_shape2;
      }
    }
  }
}

}  // namespace diagnosis::runs
