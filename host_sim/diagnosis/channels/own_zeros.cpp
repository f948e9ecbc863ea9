#include "own_zeros.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "../band/thinning.hpp"
#include "../fit/error_rates.hpp"
#include "../record/series.hpp"
#include "../sensors/ac_coupling.hpp"
#include "host_sim/response/linear_rig.hpp"

namespace diagnosis {
namespace {

constexpr double kPartOfMotion = 0.03;  // of its rms: less moves no number beyond a few percent
constexpr Eigen::Index kBlocks = 10;    // of a record, whose means tell how well its own is known

using Records = std::vector<host_sim::Record>;

// Standard deviation of a reading's mean, by the means of its blocks.
double std_of_mean(const runs::Vec& y) {
  const Eigen::Index length = y.size() / kBlocks;
  const double mean = y.mean();
  double sum = 0;
  for (Eigen::Index b = 0; b < kBlocks && length > 0; ++b)
    sum += std::pow(y.segment(b * length, length).mean() - mean, 2);
  return std::sqrt(sum / static_cast<double>(kBlocks * (kBlocks - 1)));
}

// All of them known, between masses and ground.
bool springs_known(const rig_file::RigModel& rig) {
  return std::all_of(rig.links.begin(), rig.links.end(), [](const rig_file::Link& link) {
    return !link.stiffness_N_m.estimate && !link.gravity_torque_N_m.estimate && link.a >= 1 &&
           link.b != rig_file::kBase;
  });
}

struct Zero {
  std::string channel;
  double value = 0, std = 0;
  bool stands_out = false;
};

// Of a record's displacements: their means beyond the deflection under its mean forces.
std::vector<Zero> zeros_of(const Eigen::LLT<Eigen::MatrixXd>& springs, const host_sim::Record& record) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(springs.rows());
  for (const host_sim::Channel& c : record.channels)
    if (c.quantity == host_sim::Quantity::kForce && c.dof >= 1) force[c.dof - 1] += runs::values_of(c).mean();
  const Eigen::VectorXd deflection = springs.solve(force);
  std::vector<Zero> zeros;
  for (const host_sim::Channel& c : record.channels) {
    if (c.quantity != host_sim::Quantity::kDisplacement || c.dof < 1) continue;
    const runs::Vec y = runs::values_of(c);
    const double value = y.mean() - deflection[c.dof - 1], std = std_of_mean(y);
    zeros.push_back({c.name, value, std,
                     std::abs(value) > runs::kNamed * std && std::abs(value) > kPartOfMotion * rms_about_mean(y)});
  }
  return zeros;
}

bool driven(const Records& records) {
  const auto has_force = [](const host_sim::Record& record) {
    return std::any_of(record.channels.begin(), record.channels.end(), [](const host_sim::Channel& c) {
      return c.quantity == host_sim::Quantity::kForce && rms_about_mean(runs::values_of(c)) > 0;
    });
  };
  return std::all_of(records.begin(), records.end(), has_force);
}

// Takes them out of those channels that stand out in some record; what was taken is added to `taken`, per channel the largest.
Records without_zeros(const Eigen::LLT<Eigen::MatrixXd>& springs, const Records& records,
                      const std::vector<std::string>& of, std::vector<Zero>& taken) {
  Records clean = records;
  for (host_sim::Record& record : clean)
    for (const Zero& zero : zeros_of(springs, record)) {
      if (std::find(of.begin(), of.end(), zero.channel) == of.end()) continue;
      for (host_sim::Channel& c : record.channels)
        if (c.name == zero.channel)
          for (double& value : c.values) value -= zero.value;
      const auto known =
          std::find_if(taken.begin(), taken.end(), [&](const Zero& t) { return t.channel == zero.channel; });
      if (known == taken.end())
        taken.push_back(zero);
      else if (std::abs(zero.value) > std::abs(known->value))
        *known = zero;
    }
  return clean;
}

std::vector<std::string> standing_out(const Eigen::LLT<Eigen::MatrixXd>& springs, const Records& records) {
  std::vector<std::string> names;
  for (const host_sim::Record& record : records)
    for (const Zero& zero : zeros_of(springs, record))
      if (zero.stands_out && std::find(names.begin(), names.end(), zero.channel) == names.end())
        names.push_back(zero.channel);
  return names;
}

void name_zeros(const std::vector<Zero>& taken, size_t records, Diagnosis& d) {
  for (const Zero& zero : taken) {
    const bool angle = zero.channel.find("angle") == 0;
    Cause c;
    c.effect = "sensor_offset", c.where = "channel " + zero.channel, c.taken_out = true;
    c.significance = std::pow(zero.value / std::max(1e-300, zero.std), 2);
    c.parameters = {{"sensor_offset[" + zero.channel + "]", zero.value, angle ? "rad" : "m", zero.std, true}};
    d.causes.insert(d.causes.begin(), c);
  }
  if (records > 1)
    d.advice.push_back(
        "the zero of a displacement was taken out of each record by itself: the largest is said; zero it before each "
        "record");
  if (d.verdict == Verdict::kNone) d.verdict = Verdict::kExplained;
}

}  // namespace

Diagnosis judged_with_own_zeros(const Asked& asked, Diagnosis (*judge)(const Asked&)) {
  const Diagnosis as_recorded = judge(asked);
  const bool partly = as_recorded.verdict == Verdict::kPartly;
  if ((as_recorded.verdict != Verdict::kUnknown && !partly) || !driven(asked.training) || !driven(asked.holdout))
    return as_recorded;
  if (!springs_known(asked.rig)) return as_recorded;
  const Eigen::LLT<Eigen::MatrixXd> springs(host_sim::linear_rig(asked.rig).stiffness);
  if (springs.info() != Eigen::Success) return as_recorded;  // something hangs on no spring
  const std::vector<std::string> names = standing_out(springs, asked.training);
  if (names.empty()) return as_recorded;
  std::vector<Zero> taken;
  const Records training = without_zeros(springs, asked.training, names, taken),
                holdout = without_zeros(springs, asked.holdout, names, taken);
  Diagnosis d = judge({asked.rig, training, holdout, asked.options, asked.ground_known});
  if (d.verdict == Verdict::kUnknown || (partly && d.verdict == Verdict::kPartly)) return as_recorded;
  if (!pays_unseen(d, as_recorded)) return as_recorded;
  name_zeros(taken, training.size(), d);
  return d;
}

}  // namespace diagnosis
