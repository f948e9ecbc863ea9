#include "reversals.hpp"

#include <algorithm>
#include <cmath>

#include "../motion/guess.hpp"
#include "../record/motion.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kHides = 2;       // standard deviations of a rate: one sign in forty is wrong beyond
constexpr double kMostRate = 0.5;  // of a link's rms: three quarters of a swing are left however loud the noise

// Standard deviation of the noise of a DOF's rate; 0: not known (integrated).
double noise_of_rate(const Prepared& record, int dof) {
  if (const MotionTrace* v = trace_of(record, dof, 1)) return noise_level(v->y);
  const MotionTrace* x = trace_of(record, dof, 0);
  return x ? noise_level(x->y) * slope_noise(record.smooth_half, record.step_s) : 0;
}

struct Rate {
  Vec of;
  double noise = 0;
};

Rate rate_of(const Prepared& record, int end) {
  const Guess& base = record.guess.back();
  if (end == rig_file::kBase && base.given) return {base.v, 0};
  if (end <= 0) return {Vec::Zero(record.samples), 0};
  return {record.guess[static_cast<size_t>(end - 1)].v, noise_of_rate(record, end - 1)};
}

}  // namespace

Mat directions_known(const System& system, const Prepared& record) {
  Mat known = Mat::Ones(static_cast<Index>(system.dofs()), record.samples);
  for (const rig_file::Link& link : system.links) {
    const Rate a = rate_of(record, link.a), b = rate_of(record, link.b);
    const Vec w = a.of - b.of;
    const double most = kMostRate * std::sqrt(w.squaredNorm() / static_cast<double>(w.size())),
                 noise = std::min(most, kHides * std::hypot(a.noise, b.noise));
    for (Index k = 0; k < w.size(); ++k) {
      const Index last = std::max<Index>(0, k - 1), next = std::min(w.size() - 1, k + 1);
      const double step = 0.5 * std::abs(w[next] - w[last]);
      if (std::abs(w[k]) > std::max(noise, std::min(most, step))) continue;
      for (const int end : {link.a, link.b})
        if (end > 0) known(end - 1, k) = 0;
    }
  }
  return known;
}

}  // namespace diagnosis::runs
