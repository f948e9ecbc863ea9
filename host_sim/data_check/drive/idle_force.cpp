#include "host_sim/data_check/drive/idle_force.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/data_check/decay/growth.hpp"
#include "host_sim/data_check/measures/period.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kLong = 10;       // of the record: its tenth
constexpr double kVisible = 0.05;  // of the largest mean square in the record

struct Drives {
  std::vector<const Channel*> forces;  // that change
  const Channel* motion = nullptr;     // velocity before displacement before acceleration
};

// Nothing where several DOFs move, or the base.
std::optional<Drives> drives_of(const Record& record) {
  Drives all;
  int dof = rig_file::kBase;
  for (const Channel& channel : record.channels) {
    if (channel.dof == rig_file::kBase && !is_constant(channel)) return std::nullopt;
    if (channel.dof == rig_file::kBase) continue;
    if (channel.quantity == Quantity::kForce) {
      if (!is_constant(channel)) all.forces.push_back(&channel);
      continue;
    }
    if (dof != rig_file::kBase && channel.dof != dof) return std::nullopt;
    dof = channel.dof;
  }
  for (const Quantity quantity : {Quantity::kAcceleration, Quantity::kDisplacement, Quantity::kVelocity})
    if (const Channel* channel = record.find(quantity, dof); channel != nullptr && !is_constant(*channel))
      all.motion = channel;
  if (all.forces.empty() || all.motion == nullptr) return std::nullopt;
  return all;
}

bool stands(const Channel& force, const Run& run) {
  const auto first = force.values.begin() + static_cast<std::ptrdiff_t>(run.first);
  return std::all_of(first, first + static_cast<std::ptrdiff_t>(run.length),
                     [&](double value) { return value == *first; });
}

Channel part_of(const Channel& channel, size_t first, size_t length) {
  const auto from = channel.values.begin() + static_cast<std::ptrdiff_t>(first);
  Channel part = channel;
  part.values.assign(from, from + static_cast<std::ptrdiff_t>(length));
  return part;
}

// Whether the force pushes the way that the motion goes on the whole. Of an acceleration nobody can tell.
bool does_work(double force, const Channel& motion) {
  if (force == 0.0) return false;
  if (motion.quantity == Quantity::kAcceleration) return true;
  double way = motion.values.back() - motion.values.front();
  if (motion.quantity == Quantity::kVelocity) way = mean_and_rms(motion.values).mean;
  return force * way > 0.0;
}

// Of stretches as long as a tenth of the run, the largest in the whole record.
double largest_square(const Channel& motion, size_t tenth) {
  double largest = 0.0;
  for (size_t first = 0; first + kGrowthParts * tenth <= motion.values.size(); first += kGrowthParts * tenth)
    for (const double square : mean_squares_of_tenths(part_of(motion, first, kGrowthParts * tenth)))
      largest = std::max(largest, square);
  return largest;
}

Growth growth_on(const Channel& motion, const Run& run) {
  const Channel part = part_of(motion, run.first, run.length);
  const double period = period_of(part.values);
  if (period * kGrowthParts > static_cast<double>(run.length)) return {};
  const std::vector<double> squares = mean_squares_of_tenths(part);
  const Growth growth = growth_of(squares);
  if (growth.times == 0.0) return {};
  const double before =
      growth.from > 0 ? *std::max_element(squares.begin(), squares.begin() + static_cast<std::ptrdiff_t>(growth.from))
                      : 0.0;
  const double least = std::max(before, kVisible * largest_square(motion, run.length / kGrowthParts));
  return squares[growth.to] > least ? growth : Growth{};
}

}  // namespace

std::optional<Finding> find_idle_force(const Record& record) {
  const auto drives = drives_of(record);
  if (!drives) return std::nullopt;
  const Channel& force = *drives->forces.front();
  for (const Run& run : equal_runs(force.values, std::max(record.samples() / kLong, 16 * kGrowthParts))) {
    const bool idle = std::all_of(drives->forces.begin(), drives->forces.end(), [&](const Channel* other) {
      return stands(*other, run) &&
             !does_work(other->values[run.first], part_of(*drives->motion, run.first, run.length));
    });
    const Growth growth = idle ? growth_on(*drives->motion, run) : Growth{};
    if (growth.times == 0.0) continue;
    const auto last = static_cast<double>(run.first + run.length - 1);
    return Finding{
        "work", Weight::kDoubt, force.name,
        fmt::format(
            "stands at {:.6g} from {} to {} s, to the last digit, while {} gains energy (its mean square grows {:.2g} "
            "times): something else drives the rig there (another motor, a weight that sinks), or the sensor was off",
            force.values[run.first], said_instant_s(record, static_cast<double>(run.first)),
            said_instant_s(record, last), drives->motion->name, growth.times),
        growth.times};
  }
  return std::nullopt;
}

}  // namespace host_sim::data_check
