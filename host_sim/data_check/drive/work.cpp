#include "host_sim/data_check/drive/work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/data_check/drive/one_sign.hpp"
#include "host_sim/data_check/drive/power.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kTurnedOver = -0.5;  // the cosine of 120 degrees: 30 beyond what any spring or mass makes
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

std::optional<ForceAndMotion> pair_of(const Record& record, const Channel& force, size_t width, bool alone) {
  if (const Channel* v = record.find(Quantity::kVelocity, force.dof))
    return ForceAndMotion{averaged(force.values, width), averaged(v->values, width)};
  if (const Channel* x = record.find(Quantity::kDisplacement, force.dof))
    return ForceAndMotion{averaged(force.values, width), rate(x->values, width)};
  const Channel* a = record.find(Quantity::kAcceleration, force.dof);
  if (a == nullptr || !alone) return std::nullopt;
  ForceAndMotion pair{rate(force.values, width), averaged(a->values, width)};
  const double zero = mean_and_rms(pair.motion).mean;  // gravity: no rig gains speed all along
  for (double& value : pair.motion) value -= zero;
  return pair;
}

// With an offset of a sensor or without it: both have to say so, for a controller that holds a speed pushes where a load brakes it, and
// about the means that looks like a force turned over.
std::optional<Finding> given_about_means(const Work& work, const std::string& name) {
  if (!work.always_about_means || !(work.with_means < 0.0)) return std::nullopt;
  const std::string seen =
      fmt::format("{} energy out of the rig all the time (power factor {:.2f}), and a rig has none to give: ",
                  name.empty() ? "the forces take" : "takes", work.about_means);
  if (work.about_means < kTurnedOver && work.with_means < kTurnedOver)
    return Finding{"polarity", name.empty() ? Weight::kFault : Weight::kDoubt, name,
                   seen + "force or motion is turned over; " +
                       (name.empty() ? "change the sign of one of the columns" : kSignIsChanged),
                   work.about_means};
  return Finding{"work", Weight::kDoubt, name, seen + "force or motion is turned over, or one of them is late",
                 work.about_means};
}

// Of a single force: what several of them share a speed with, their means do not tell.
std::optional<Finding> given_by_means(const Work& work, const std::string& name) {
  if (name.empty() || !work.always_as_measured || !(work.as_measured < kTurnedOver)) return std::nullopt;
  return Finding{
      "work", Weight::kDoubt, name,
      fmt::format("takes energy out of the rig all the time (power factor {:.2f}), by its mean: force or motion is "
                  "turned over, the zero of a sensor is off, or the file lacks what else drives (a motor, a "
                  "weight that sinks)",
                  work.as_measured),
      work.as_measured};
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
  std::vector<ForceAndMotion> pairs;
  for (const Channel* force : forces) {
    auto pair = pair_of(record, *force, width, forces.size() == 1);
    if (!pair) return std::nullopt;
    pairs.push_back(std::move(*pair));
  }
  const Work work = work_of(pairs);
  if (work.runs_down) return std::nullopt;
  const std::string name = forces.size() == 1 ? forces[0]->name : "";
  if (auto given = given_about_means(work, name)) return given;
  return given_by_means(work, name);
}

}  // namespace host_sim::data_check
