#include "host_sim/data_check/drive/power.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kParts = 10;

struct Sums {
  double power = 0.0, force = 0.0, motion = 0.0;  // of products and squares
};

// Sum of each part about these means.
Sums sums_of(const ForceAndMotion& pair, double mean_force, double mean_motion, Sums (&parts)[kParts]) {
  Sums all;
  for (size_t i = 0; i < pair.force.size(); ++i) {
    const double force = pair.force[i] - mean_force, motion = pair.motion[i] - mean_motion;
    Sums& part = parts[i * kParts / pair.force.size()];
    part.power += force * motion, part.motion += motion * motion;
    all.power += force * motion, all.force += force * force, all.motion += motion * motion;
  }
  return all;
}

bool all_give(const Sums (&parts)[kParts]) {
  return std::all_of(std::begin(parts), std::end(parts), [](const Sums& part) { return part.power < 0.0; });
}

}  // namespace

Work work_of(const std::vector<ForceAndMotion>& pairs) {
  Sums about[kParts], measured[kParts];
  double power = 0.0, measured_power = 0.0, squares = 0.0, measured_squares = 0.0;
  bool one_way = true;
  for (const ForceAndMotion& pair : pairs) {
    const Sums of = sums_of(pair, mean_and_rms(pair.force).mean, mean_and_rms(pair.motion).mean, about),
               with = sums_of(pair, 0.0, 0.0, measured);
    power += of.power, measured_power += with.power;
    one_way = one_way && with.motion > 2.0 * of.motion;
    squares += std::sqrt(of.force * of.motion), measured_squares += std::sqrt(with.force * with.motion);
  }
  Work work;
  if (squares > 0.0) work.about_means = power / squares, work.with_means = measured_power / squares;
  if (measured_squares > 0.0) work.as_measured = measured_power / measured_squares;
  work.always_about_means = all_give(about), work.always_as_measured = all_give(measured);
  work.runs_down =
      one_way && std::is_sorted(std::begin(measured), std::end(measured),
                                [](const Sums& one, const Sums& other) { return one.motion > other.motion; });
  return work;
}

}  // namespace host_sim::data_check
