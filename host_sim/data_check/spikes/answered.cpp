#include "host_sim/data_check/spikes/answered.hpp"

#include <cmath>

namespace host_sim::data_check {
namespace {

constexpr double kTells = 0.1;  // of the momentum, standard deviation: less, and a channel says nothing
// Samples before and behind a blow over which a change is taken: a motion of 20 and more samples a period has hardly turned by then.
constexpr size_t kReaches[] = {2, 4, 8};
constexpr double kPlainly =
    2.0;                       // deviations: one that shows them within some reach is late, and no witness against them
constexpr size_t kStride = 7;  // of the stretches that tell the scatter

// How the velocity changes across a stretch more than before and behind it, times what one unit of it makes of a channel's own values.
class Change {
 public:
  Change(const Channel& channel, size_t reach, double step_s) : channel_(channel), reach_(reach) {
    per_velocity_ = channel.quantity == Quantity::kDisplacement   ? static_cast<double>(reach) * step_s
                    : channel.quantity == Quantity::kAcceleration ? 1.0 / step_s
                                                                  : 1.0;
  }
  bool fits(const Gap& gap) const {
    const size_t room = reach_ + beside(gap);
    return gap.first > room && gap.first + gap.width + room < channel_.values.size();
  }
  double across(const Gap& gap) const {
    const size_t step = beside(gap);
    return alone(gap.first, gap.width) -
           0.5 * (alone(gap.first - step, gap.width) + alone(gap.first + step, gap.width));
  }
  size_t room() const { return 3 * reach_ + 2; }  // before and behind a single sample

  double per_velocity() const { return per_velocity_; }

 private:
  size_t beside(const Gap& gap) const { return 2 * reach_ + gap.width + 1; }
  double alone(size_t first, size_t width) const {
    const std::vector<double>& x = channel_.values;
    const size_t before = first - 1, behind = first + width;
    if (channel_.quantity == Quantity::kVelocity) return x[behind + reach_ - 1] - x[before - reach_ + 1];
    if (channel_.quantity == Quantity::kDisplacement)
      return x[behind + reach_] - x[behind] - (x[before] - x[before - reach_]);
    double sum = 0.0;
    for (size_t i = before - reach_ + 1; i < behind + reach_; ++i) sum += x[i];
    return sum;
  }

  const Channel& channel_;
  size_t reach_;
  double per_velocity_;
};

// The sum of a blow over its samples, less the line between the samples beside it.
double sum_of(const std::vector<double>& force, const Gap& gap) {
  double sum = 0.0;
  for (size_t k = 0; k < gap.width; ++k) sum += force[gap.first + k];
  return sum - 0.5 * static_cast<double>(gap.width) * (force[gap.first - 1] + force[gap.first + gap.width]);
}

// Mean square of a change where no blow is within its reach.
double scatter_of(const Change& change, const std::vector<Gap>& blows, size_t samples) {
  const size_t room = change.room();
  double sum = 0.0, count = 0.0;
  size_t next = 0;
  for (size_t i = room + 1; i + room + 1 < samples; i += kStride) {
    while (next < blows.size() && blows[next].first + blows[next].width + room < i) ++next;
    if (next < blows.size() && blows[next].first < i + room + 1) continue;
    const double value = change.across({i, 1, 0.0});
    sum += value * value, count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

Answered shown_by(const Change& change, const Channel& channel, const Channel& force, const std::vector<Gap>& blows,
                  double velocity_step) {
  double shown = 0.0, square = 0.0;
  for (const Gap& blow : blows) {
    if (!change.fits(blow)) continue;
    const double expected = change.per_velocity() * velocity_step * sum_of(force.values, blow);
    shown += expected * change.across(blow), square += expected * expected;
  }
  const double scatter = scatter_of(change, blows, channel.values.size());
  return square > 0.0 && scatter > 0.0 ? Answered{shown / square, std::sqrt(scatter / square)} : Answered();
}

}  // namespace

Answered answered(const Record& record, const Channel& force, const std::vector<Gap>& blows, double velocity_step) {
  Answered best, shows;
  if (blows.empty() || !(velocity_step > 0.0)) return best;
  for (const Channel& channel : record.channels) {
    if (channel.dof != force.dof || channel.quantity == Quantity::kForce) continue;
    for (const size_t reach : kReaches) {
      const Answered one =
          shown_by(Change(channel, reach, record.sample_period_s), channel, force, blows, velocity_step);
      if (!(one.std > 0.0) || one.std > kTells) continue;
      if (best.std == 0.0 || one.std < best.std) best = one;
      if (one.share - kPlainly * one.std > 0.5 && (shows.std == 0.0 || one.std < shows.std)) shows = one;
    }
  }
  return shows.std > 0.0 ? shows : best;
}

}  // namespace host_sim::data_check
