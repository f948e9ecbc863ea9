#include "own_zeros.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "../fit/error_rates.hpp"
#include "../sensors/ac_coupling.hpp"

namespace diagnosis {
namespace {

constexpr double kPartOfMotion = 0.03;  // of its rms: less moves no number beyond a few percent
constexpr size_t kBlocks = 10;          // of a record, whose means tell how well its own is known

using Records = std::vector<host_sim::Record>;

double mean_of(const std::vector<double>& values, size_t from, size_t to) {
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(from),
                         values.begin() + static_cast<std::ptrdiff_t>(to), 0.0) /
         static_cast<double>(to - from);
}
double mean_of(const std::vector<double>& values) { return mean_of(values, 0, values.size()); }

struct Spread {
  double rms = 0, of_mean = 0;  // about the mean; standard deviation of the mean
};
Spread spread_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  Spread spread;
  for (const double value : values) spread.rms += (value - mean) * (value - mean);
  spread.rms = std::sqrt(spread.rms / static_cast<double>(values.size()));
  const size_t length = values.size() / kBlocks;
  for (size_t b = 0; b < kBlocks && length > 0; ++b)
    spread.of_mean += std::pow(mean_of(values, b * length, (b + 1) * length) - mean, 2);
  spread.of_mean = std::sqrt(spread.of_mean / static_cast<double>(kBlocks * (kBlocks - 1)));
  return spread;
}

// Springs, known all of them, between masses and ground; empty where they are not.
Eigen::MatrixXd stiffness_of(const rig_file::RigModel& rig) {
  const auto n = static_cast<Eigen::Index>(rig.dofs.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for (const rig_file::Link& link : rig.links) {
    if (link.stiffness_N_m.estimate || link.gravity_torque_N_m.estimate || link.a < 1 || link.b == rig_file::kBase)
      return {};
    const double k = link.stiffness_N_m.value + link.gravity_torque_N_m.value;
    const Eigen::Index a = link.a - 1, b = link.b - 1;
    stiffness(a, a) += k;
    if (b >= 0) stiffness(b, b) += k, stiffness(a, b) -= k, stiffness(b, a) -= k;
  }
  return stiffness;
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
    if (c.quantity == host_sim::Quantity::kForce && c.dof >= 1) force[c.dof - 1] += mean_of(c.values);
  const Eigen::VectorXd deflection = springs.solve(force);
  std::vector<Zero> zeros;
  for (const host_sim::Channel& c : record.channels) {
    if (c.quantity != host_sim::Quantity::kDisplacement || c.dof < 1) continue;
    const Spread spread = spread_of(c.values);
    const double value = mean_of(c.values) - deflection[c.dof - 1];
    zeros.push_back({c.name, value, spread.of_mean,
                     std::abs(value) > runs::kNamed * spread.of_mean && std::abs(value) > kPartOfMotion * spread.rms});
  }
  return zeros;
}

bool driven(const Records& records) {
  const auto has_force = [](const host_sim::Record& record) {
    return std::any_of(record.channels.begin(), record.channels.end(), [](const host_sim::Channel& c) {
      return c.quantity == host_sim::Quantity::kForce && spread_of(c.values).rms > 0;
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
  const Eigen::MatrixXd stiffness = stiffness_of(asked.rig);
  if (stiffness.size() == 0) return as_recorded;
  const Eigen::LLT<Eigen::MatrixXd> springs(stiffness);
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
