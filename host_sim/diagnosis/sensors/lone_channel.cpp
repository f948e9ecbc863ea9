#include "lone_channel.hpp"

#include <algorithm>
#include <cmath>

#include "../motion/guess.hpp"

namespace diagnosis {
namespace {

constexpr double kTheSame = 0.2;  // of a channel's motion: what a second sensor's calibration and noise may differ by

bool among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Its means over an eighth of a period: what is faster is noise as much as motion.
runs::Vec slow_part(const runs::Vec& y, const runs::Prepared& p) {
  const auto half = static_cast<Eigen::Index>(p.period_s / 16 / p.step_s);
  return y - runs::without_drift(y, {std::max<Eigen::Index>(1, half)});
}

// Of the channels named, the most that one differs from what the others tell of its DOF, over its own motion.
double most_different(runs::Prepared p, const std::vector<std::string>& names) {
  std::vector<runs::MotionTrace> apart, others;
  for (const runs::MotionTrace& t : p.traces) (among(names, t.channel) ? apart : others).push_back(t);
  p.traces = others;
  runs::renew_motion(p);
  double most = 0;
  for (const runs::MotionTrace& t : apart) {
    const runs::Guess& g = p.guess[static_cast<size_t>(t.dof)];
    const runs::Vec own = slow_part(t.y, p), told = slow_part(t.quantity == 0 ? g.x : t.quantity == 1 ? g.v : g.a, p);
    most = std::max(most, rms_about_mean(own - told) / std::max(1e-300, rms_about_mean(own)));
  }
  return most;
}

}  // namespace

std::vector<std::string> spared_by_others(const host_sim::Record& record, host_sim::Quantity quantity) {
  std::vector<std::string> names;
  for (const host_sim::Channel& c : record.channels) {
    const auto another = [&](const host_sim::Channel& o) {
      return o.dof == c.dof && o.quantity != quantity && o.quantity != host_sim::Quantity::kForce;
    };
    if (c.dof >= 1 && c.quantity == quantity && std::any_of(record.channels.begin(), record.channels.end(), another))
      names.push_back(c.name);
  }
  return names;
}

bool go_with_the_others(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records,
                        const std::vector<std::string>& names) {
  const std::vector<runs::Prepared> prepared = runs::prepare_all(rig, records, {});
  return std::all_of(prepared.begin(), prepared.end(),
                     [&](const runs::Prepared& p) { return most_different(p, names) < kTheSame; });
}

std::vector<host_sim::Record> without_channels(std::vector<host_sim::Record> records,
                                               const std::vector<std::string>& names) {
  for (host_sim::Record& record : records)
    record.channels.erase(std::remove_if(record.channels.begin(), record.channels.end(),
                                         [&](const host_sim::Channel& c) { return among(names, c.name); }),
                          record.channels.end());
  return records;
}

}  // namespace diagnosis
