// Steps by the Taylor series: to the next sample, the next knot of the excitation or the next event, whichever comes first.
#include <algorithm>
#include <cmath>

#include "host_sim/plant/motion/integrator_working.hpp"

namespace host_sim {
namespace {

constexpr double kSameTime = 1e-15;  // two times of this share of a step are one
constexpr int kMostHalvings = 60;

}  // namespace

// The root function of all that is nearest to its event, positive before it. A sliding link waits for its rate to leave the sign
// that it has, a stuck one for what its hold has in reserve to run out.
double Integrator::Working::nearest_event(double step_s, double theta) {
  series->state(theta, ahead.data());
  excite(t + theta * step_s);
  equations.root_functions(t + theta * step_s, ahead.data(), force.data(), base, modes, root_scale, reserve.data());
  double nearest = std::numeric_limits<double>::infinity();
  size_t root = 0;
  for (size_t l = 0; l < equations.links().size(); ++l) {
    if (!equations.links()[l].watch_rate) continue;
    const int sign = modes.rate_sign[l];
    nearest = std::min(nearest, sign < 0 ? -reserve[root] : reserve[root]);
    ++root;
  }
  return nearest;
}

// Regula falsi with the Illinois correction (Dowell and Jarratt, BIT 11, 1971), after begin has been moved to where the functions
// are positive: behind an event they begin at zero.
double Integrator::Working::event_between(double step_s, double begin, double end) {
  double at_end = nearest_event(step_s, end), at_begin = nearest_event(step_s, begin);
  double probe = 0.5 * (begin + end);
  for (int k = 0; at_begin <= 0.0; ++k, probe = begin + 0.5 * (probe - begin)) {
    if (k == kMostHalvings) return begin;
    const double at_probe = nearest_event(step_s, probe);
    if (at_probe > 0.0)
      begin = probe, at_begin = at_probe;
    else
      end = probe, at_end = at_probe;
  }
  int moved = 0;  // the end that the last probe moved: 1 the begin, -1 the end
  while (end - begin > kSameTime) {
    const double secant = begin + (end - begin) * at_begin / (at_begin - at_end);
    const double middle = secant > begin && secant < end ? secant : 0.5 * (begin + end);
    if (middle == begin || middle == end) break;
    const double at_middle = nearest_event(step_s, middle);
    if (at_middle == 0.0) return middle;
    if (at_middle > 0.0) {
      begin = middle, at_begin = at_middle;
      if (moved > 0) at_end *= 0.5;  // it has stayed twice
      moved = 1;
    } else {
      end = middle, at_end = at_middle;
      if (moved < 0) at_begin *= 0.5;
      moved = -1;
    }
  }
  return end;
}

// What has come to its event there changes its mode.
void Integrator::Working::series_event(double step_s, double theta) {
  const double nearest = nearest_event(step_s, theta);
  std::vector<int> direction(equations.roots(), 0);
  size_t root = 0;
  for (size_t l = 0; l < equations.links().size(); ++l) {
    if (!equations.links()[l].watch_rate) continue;
    const int sign = modes.rate_sign[l];
    const double left = sign < 0 ? -reserve[root] : reserve[root];
    if (left <= std::max(0.0, nearest)) direction[root] = sign < 0 ? 1 : -1;
    ++root;
  }
  std::copy(ahead.begin(), ahead.end(), y.begin());  // in place: ARKODE knows where y is
  t += theta * step_s;
  last_event_s = t;
  excite(t);
  const std::vector<bool> resting = equations.apply_roots(direction.data(), modes);
  equations.solve_rest(t, y.data(), force.data(), base, resting, modes);
  ++events;
}

bool Integrator::Working::series_step(double t_s) {
  ahead.resize(y.size());
  reserve.resize(equations.roots());
  const double until = std::min(t_s, series->smooth_until(t));
  if (until <= t) return false;
  const double longest = series->longest_step_s();
  const double end = until - t > longest ? t + (until - t) / std::ceil((until - t) / longest) : until;
  const double step_s = end - t;
  if (step_s <= 0.0 || !series->expand(t, step_s, y.data(), modes, root_scale)) return false;
  restart = true;
  double event = 2.0;
  if (equations.roots() > 0) {
    for (size_t l = 0; l < equations.links().size(); ++l) {
      if (!equations.links()[l].watch_rate || modes.rate_sign[l] == 0) continue;
      const double dip = series->nearest_to_rest(l, modes.rate_sign[l]);
      if (dip < std::min(event, 1.0) && nearest_event(step_s, dip) < 0.0) event = dip;
    }
    if (event > 1.0 && nearest_event(step_s, 1.0) < 0.0) event = 1.0;
  } else {
    series->state(1.0, ahead.data());
  }
  if (event <= 1.0) {
    event = event_between(step_s, 0.0, event);
    if (event == 0.0 && last_event_s == t) return false;
    series_event(step_s, event);
    return true;
  }
  std::copy(ahead.begin(), ahead.end(), y.begin());  // in place: ARKODE knows where y is
  t = end;
  return true;
}

}  // namespace host_sim
