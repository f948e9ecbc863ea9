#include "../band/band.hpp"
#include "fused.hpp"
#include "guess.hpp"

namespace diagnosis::runs {
namespace {

// Of the slowest motion. It drives the rig, to its amplitude: what the mean over so many takes of it, in two passes, is below
// 1 / (10 pi)^2, a thousandth.
constexpr double kPeriodsOfDrift = 10;
constexpr int kPasses = 2;

}  // namespace

void tell_drift(Prepared& p) {
  const int integrals = p.base.reading[0].size() ? 0 : p.base.reading[1].size() ? 1 : 2;
  const Vec& reading = p.base.reading[static_cast<size_t>(integrals)];
  if (integrals == 0 || reading.size() == 0) return;
  const double longest_s = 1 / lowest_frequency(reading, p.step_s, integrals);
  p.base.slow_half = static_cast<Index>(0.5 * kPeriodsOfDrift * longest_s / p.step_s);
}

void renew_base(Prepared& p) {
  if (!p.base.given()) return;
  const auto measured = [&](size_t quantity) {
    return p.base.reading[quantity].size() ? &p.base.reading[quantity] : nullptr;
  };
  Guess& base = p.guess.back();
  const Drift drift{p.base.slow_half, kPasses};
  base = measured(2) && (measured(0) || measured(1))
             ? fused_by_acceleration(measured(0), measured(1), *measured(2), p.step_s)
             : guess_of({measured(0), measured(1), measured(2)}, p.step_s, p.smooth_half, drift);
  if (measured(1) && !measured(0)) base.x = without_drift(integral(base.v, p.step_s), drift);
  if (p.base.ridden) base.x.setZero(), base.v.setZero();
}

}  // namespace diagnosis::runs
