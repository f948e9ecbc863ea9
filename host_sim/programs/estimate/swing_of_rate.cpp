#include "host_sim/programs/estimate/swing_of_rate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/measures/period.hpp"
#include "host_sim/programs/shared/weighs.hpp"

namespace host_sim {
namespace {

constexpr double kBent = 0.02;

bool rate_alone(const Record& record, int dof) {
  return record.find(Quantity::kVelocity, dof) != nullptr && record.find(Quantity::kDisplacement, dof) == nullptr;
}

// Sums of u and of u - sin u, squared: the angle is the integral of the rate about its mean over one period, period by period, so that no
// drift is in it.
struct Swing {
  double angle = 0, bend = 0;
};
void add_swing(const Channel& rate, double step_s, Swing& swing) {
  const auto period = static_cast<size_t>(data_check::period_of(rate.values));
  if (period < 4) return;
  for (size_t from = 0; from + period <= rate.values.size(); from += period) {
    std::vector<double> angle(period, 0.0);
    double mean_rate = 0, mean = 0;
    for (size_t i = 0; i < period; ++i) mean_rate += rate.values[from + i] / static_cast<double>(period);
    for (size_t i = 1; i < period; ++i) angle[i] = angle[i - 1] + step_s * (rate.values[from + i] - mean_rate);
    for (double u : angle) mean += u / static_cast<double>(period);
    for (double u : angle) {
      swing.angle += (u - mean) * (u - mean);
      swing.bend += std::pow(u - mean - std::sin(u - mean), 2);
    }
  }
}

}  // namespace

std::vector<std::string> doubt_bent_gravity(const rig_file::RigModel& model, const std::vector<Record>& records,
                                            std::vector<ParameterResult>& parameters) {
  std::vector<std::string> notes;
  for (size_t l = 0; l < model.links.size(); ++l) {
    const rig_file::Link& link = model.links[l];
    if (!weighs(link) || link.b != rig_file::kGround || records.empty() || !rate_alone(records.front(), link.a))
      continue;
    Swing swing;
    for (const Record& record : records)
      if (const Channel* rate = record.find(Quantity::kVelocity, link.a))
        add_swing(*rate, record.sample_period_s, swing);
    if (!(swing.bend > kBent * kBent * swing.angle)) continue;
    for (ParameterResult& p : parameters)
      if (!p.info.dof_term && p.info.place == static_cast<int>(l) && p.status == firmware::EstimateStatus::kValid)
        p.status = firmware::EstimateStatus::kBiasSuspect;
    notes.push_back(
        fmt::format("DOF {} swings so far that sin(u) is no longer its angle, and its rate alone is measured: behind "
                    "the high-pass that takes the drift off an integrated angle a gravity torque is not the same; "
                    "host_sim diagnose, which runs the model itself, or an angle sensor gives it",
                    link.a));
  }
  return notes;
}

}  // namespace host_sim
