#include "host_sim/data_check/flat/plateau.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim::data_check {
namespace {

constexpr double kBands = 1.5;       // what has to be missing beyond a stretch that is flat within one
constexpr double kDeviations = 3.0;  // of a sum of noise
constexpr double kStill = 0.01;      // of the usual mean square of steps: a tenth of the usual motion
constexpr double kTells =
    4.0;  // times the steps that pass for still are those that are usual, or the force tells nothing
constexpr double kMoves = 0.1;  // of its rms: what a force changes by, at least, where a ramp ends

// How far the integral of a derivative goes off a straight line between the ends of the stretch, which are of one height: an offset
// of the derivative's sensor is no motion.
double climb(const std::vector<double>& derivative, const Run& run, double sample_period_s) {
  double sum = 0.0, total = 0.0, farthest = 0.0;
  for (size_t i = run.first; i < run.first + run.length; ++i) total += derivative[i];
  for (size_t i = 0; i < run.length; ++i) {
    sum += derivative[run.first + i];
    farthest = std::max(farthest, std::abs(sum - total * static_cast<double>(i + 1) / static_cast<double>(run.length)));
  }
  return farthest * sample_period_s;
}

bool follows(Quantity derivative, Quantity of) {
  return (of == Quantity::kDisplacement && derivative == Quantity::kVelocity) ||
         (of == Quantity::kVelocity && derivative == Quantity::kAcceleration);
}

}  // namespace

Witnesses::Witnesses(const Record& record, const Channel& channel) : sample_period_s_(record.sample_period_s) {
  for (const Channel& other : record.channels) {
    if (&other == &channel || other.values.size() != channel.values.size()) continue;
    const bool force = other.quantity == Quantity::kForce;
    if (!force && (other.dof != channel.dof || !follows(other.quantity, channel.quantity))) continue;
    Statistics statistics = statistics_of(other);
    if (statistics.lowest == statistics.highest) continue;
    (force ? forces_ : derivatives_).push_back({&other, statistics});
  }
}

bool Witnesses::hold(const Run& run, double band) const {
  for (const Witness& witness : derivatives_) {
    // a sum of noise that is tied to zero at both ends deviates in its middle by half of what a free one does
    const double noise = witness.statistics.noise * sample_period_s_ * std::sqrt(static_cast<double>(run.length)) / 2.0;
    if (kDeviations * noise > kBands * band) continue;  // too noisy to tell
    return climb(witness.channel->values, run, sample_period_s_) < kBands * band + kDeviations * noise;
  }
  return !forces_.empty() &&
         std::all_of(forces_.begin(), forces_.end(), [&](const Witness& force) { return stands_still(force, run); });
}

bool Witnesses::stands_still(const Witness& force, const Run& run) const {
  const std::vector<double>& values = force.channel->values;
  const size_t quarter = run.length / 4, first = run.first + quarter, end = run.first + run.length - quarter;
  if (quarter == 0 || run.first < quarter || run.first + run.length + quarter > values.size()) return false;
  const size_t lag = std::max<size_t>(1, (end - first) / 4);
  const double usual = mean_square_step(values, 0, values.size(), lag);
  // steps of white noise have twice its mean square
  const double still = 4.0 * std::pow(force.statistics.noise, 2) + kStill * usual;
  if (usual < kTells * still || mean_square_step(values, first, end, lag) > still) return false;
  double mean = 0.0;
  for (size_t i = first; i < end; ++i) mean += values[i] / static_cast<double>(end - first);
  const double moves = std::max(kMoves * force.statistics.rms, 5.0 * force.statistics.noise);
  const auto moves_at = [&](size_t at) {
    return std::any_of(values.begin() + static_cast<std::ptrdiff_t>(at - quarter),
                       values.begin() + static_cast<std::ptrdiff_t>(at + quarter),
                       [&](double value) { return std::abs(value - mean) > moves; });
  };
  return moves_at(run.first) && moves_at(run.first + run.length);
}

}  // namespace host_sim::data_check
