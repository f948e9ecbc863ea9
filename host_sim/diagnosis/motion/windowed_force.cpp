#include "windowed_force.hpp"

#include <algorithm>
#include <cmath>

#include "../band/band.hpp"
#include "host_sim/records/median.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kMedianOfNormal = 0.6745;  // of a normal law's magnitude, per standard deviation
constexpr double kBlowOverNoise = 30;       // a random force reaches 5 times what its median says
constexpr double kBlowsShare = 0.2;         // of the samples, at most

}  // namespace

Windowed windowed(const Vec& f) {
  const auto median_of = [](const Vec& y) { return host_sim::median({y.data(), y.data() + y.size()}); };
  const double zero = median_of(f), sigma = median_of((f.array() - zero).abs()) / kMedianOfNormal;
  const auto quiet = [&](Index i) { return std::abs(f[i] - zero) <= kNoiseReaches * sigma; };
  Index loud = 0;
  for (Index i = 0; i < f.size(); ++i) loud += !quiet(i);
  const double peak = (f.array() - zero).abs().maxCoeff();
  if (!(peak > kBlowOverNoise * sigma) || static_cast<double>(loud) > kBlowsShare * static_cast<double>(f.size()))
    return {f, {}, {}};
  Windowed w{f, Vec::Zero(f.size()), Vec::Zero(f.size())};
  for (Index i = 0; i < f.size();) {
    Index to = i;
    while (to < f.size() && !quiet(to)) ++to;
    // lone samples beyond the noise are noise
    const Index reach = to - i, from = std::max<Index>(0, i - reach), until = std::min(f.size(), to + reach);
    if (reach > 1) w.blow.segment(from, until - from).setOnes();
    i = to + 1;
  }
  for (Index i = 0; i < f.size(); ++i)
    if (w.blow[i] == 0) w.force[i] = zero, w.off[i] = f[i] - zero;
  return w;
}

Vec noise_in_blows(const Windowed& w, int by) {
  if (w.blow.size() == 0) return {};
  const Vec off = thinned(w.off, by);
  Vec blow = thinned(w.blow, by);
  for (double& share : blow) share = share > 0.5 ? 1 : 0;
  const double quiet = static_cast<double>(blow.size()) - blow.sum();
  return std::sqrt(off.squaredNorm() / std::max(1.0, quiet)) * blow;
}

}  // namespace diagnosis::runs
