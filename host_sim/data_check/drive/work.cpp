#include "host_sim/data_check/drive/work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/data_check/drive/one_sign.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kTurnedOver = -0.5;  // the cosine of 120 degrees: 30 beyond what any spring or mass makes
constexpr size_t kParts = 10;         // all below nought: chance makes one in 2^10
constexpr size_t kFewest = 256;

// Means over `width` steps between samples, trapezoid; one for each start.
std::vector<double> averaged(const std::vector<double>& y, size_t width) {
  std::vector<double> integral(y.size(), 0.0), mean(y.size() - width);
  for (size_t i = 1; i < y.size(); ++i) integral[i] = integral[i - 1] + 0.5 * (y[i - 1] + y[i]);
  for (size_t i = 0; i < mean.size(); ++i) mean[i] = (integral[i + width] - integral[i]) / static_cast<double>(width);
  return mean;
}

// Mean rates over `width` steps, per step.
std::vector<double> rate(const std::vector<double>& y, size_t width) {
  std::vector<double> mean(y.size() - width);
  for (size_t i = 0; i < mean.size(); ++i) mean[i] = (y[i + width] - y[i]) / static_cast<double>(width);
  return mean;
}

// A force and what it works on: their product is a power, or one weighted with the square of the frequency.
struct Pair {
  std::vector<double> force, motion;
};

std::optional<Pair> pair_of(const Record& record, const Channel& force, size_t width, bool alone) {
  if (const Channel* v = record.find(Quantity::kVelocity, force.dof))
    return Pair{averaged(force.values, width), averaged(v->values, width)};
  if (const Channel* x = record.find(Quantity::kDisplacement, force.dof))
    return Pair{averaged(force.values, width), rate(x->values, width)};
  const Channel* a = record.find(Quantity::kAcceleration, force.dof);
  if (a == nullptr || !alone) return std::nullopt;
  return Pair{rate(force.values, width), averaged(a->values, width)};
}

struct Work {
  double power_factor = 0.0;
  bool always_given = false;
};

void take_off_mean(std::vector<double>& y) {
  const double mean = mean_and_rms(y).mean;
  for (double& value : y) value -= mean;
}

Work work_of(std::vector<Pair>& pairs) {
  double parts[kParts] = {}, squares = 0.0;
  for (Pair& pair : pairs) {
    take_off_mean(pair.force);
    take_off_mean(pair.motion);
    double force = 0.0, motion = 0.0;
    for (size_t i = 0; i < pair.force.size(); ++i) {
      parts[i * kParts / pair.force.size()] += pair.force[i] * pair.motion[i];
      force += pair.force[i] * pair.force[i], motion += pair.motion[i] * pair.motion[i];
    }
    squares += std::sqrt(force * motion);
  }
  double sum = 0.0;
  bool always_given = true;
  for (const double part : parts) sum += part, always_given = always_given && part < 0.0;
  return {squares > 0.0 ? sum / squares : 0.0, always_given};
}

}  // namespace

std::optional<Finding> find_negative_work(const Record& record, const Drive& drive) {
  std::vector<const Channel*> forces;
  for (const Channel& channel : record.channels) {
    const bool moves = mean_and_rms(channel.values).rms > 0.0;
    if (channel.dof == rig_file::kBase && moves) return std::nullopt;
    if (channel.quantity == Quantity::kForce && moves) forces.push_back(&channel);
  }
  if (forces.empty() || record.samples() < kFewest) return std::nullopt;
  const double quarter = 0.25 / (drive.to_Hz * record.sample_period_s + 1e-300);
  const auto width = static_cast<size_t>(std::clamp(quarter, 1.0, static_cast<double>(record.samples()) / 64.0));
  std::vector<Pair> pairs;
  for (const Channel* force : forces) {
    auto pair = pair_of(record, *force, width, forces.size() == 1);
    if (!pair) return std::nullopt;
    pairs.push_back(std::move(*pair));
  }
  const Work work = work_of(pairs);
  if (!work.always_given) return std::nullopt;
  const std::string name = forces.size() == 1 ? forces[0]->name : "";
  const std::string which = name.empty() ? "the forces take" : "takes";
  const std::string seen = fmt::format(
      "{} energy out of the rig all the time (power factor {:.2f}), and a rig has none "
      "to give: ",
      which, work.power_factor);
  if (work.power_factor < kTurnedOver)
    return Finding{"polarity", name.empty() ? Weight::kFault : Weight::kDoubt, name,
                   seen + "force or motion is turned over; " +
                       (name.empty() ? "change the sign of one of the columns" : kSignIsChanged),
                   work.power_factor};
  return Finding{"work", Weight::kDoubt, name, seen + "force or motion is turned over, or one of them is late",
                 work.power_factor};
}

}  // namespace host_sim::data_check
