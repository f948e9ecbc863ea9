#include "riding.hpp"

#include <algorithm>
#include <cmath>

#include "series.hpp"

namespace diagnosis {
namespace {

using host_sim::Channel;
using host_sim::Quantity;

auto mapped(const std::vector<double>& y) { return Series::Map(y.data(), static_cast<Eigen::Index>(y.size())); }

// Mean speed of a base that runs on: more than it swings by; 0 where it stays.
double running_speed(const host_sim::Record& r) {
  if (const Channel* place = r.find(Quantity::kDisplacement, rig_file::kBase)) {
    const Series x = mapped(place->values);
    return travels(x) ? slope_of_line(x) / r.sample_period_s : 0;
  }
  const Channel* speed = r.find(Quantity::kVelocity, rig_file::kBase);
  if (!speed) return 0;
  const double mean = mapped(speed->values).mean();
  return std::abs(mean) > rms_about_mean(mapped(speed->values)) ? mean : 0;
}

bool springs_everywhere(const rig_file::RigModel& rig) {
  return std::all_of(rig.links.begin(), rig.links.end(),
                     [](const rig_file::Link& l) { return l.stiffness_N_m.estimate || l.stiffness_N_m.value != 0; });
}

void take_off(double constant, double slope, std::vector<double>& y) {
  for (size_t i = 0; i < y.size(); ++i) y[i] -= constant + slope * static_cast<double>(i);
}

// tied: each DOF is as fast on the mean, whatever its sensor says.
void count_from_base(double speed, bool tied, host_sim::Record& r) {
  for (Channel& c : r.channels) {
    if (c.quantity == Quantity::kDisplacement) take_off(0, speed * r.sample_period_s, c.values);
    if (c.quantity == Quantity::kVelocity) take_off(tied ? mapped(c.values).mean() : speed, 0, c.values);
  }
}

}  // namespace

bool touches_ground(const rig_file::RigModel& rig) {
  return std::any_of(rig.links.begin(), rig.links.end(),
                     [](const rig_file::Link& l) { return l.a == rig_file::kGround || l.b == rig_file::kGround; });
}

bool on_measured_base(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records) {
  return !touches_ground(rig) && std::any_of(records.begin(), records.end(), [](const host_sim::Record& r) {
    return std::any_of(r.channels.begin(), r.channels.end(), [](const Channel& c) { return c.dof == rig_file::kBase; });
  });
}

bool base_runs_on(const std::vector<host_sim::Record>& records) {
  return std::any_of(records.begin(), records.end(), [](const host_sim::Record& r) { return running_speed(r) != 0; });
}

std::vector<host_sim::Record> riding(const rig_file::RigModel& rig, std::vector<host_sim::Record> records) {
  for (host_sim::Record& r : records) {
    if (const double speed = running_speed(r)) count_from_base(speed, springs_everywhere(rig), r);
    const bool placed = std::any_of(r.channels.begin(), r.channels.end(), [](const Channel& c) {
      return c.quantity == Quantity::kDisplacement && c.dof != rig_file::kBase;
    });
    for (Channel& c : r.channels)
      if (!placed && c.quantity == Quantity::kDisplacement) take_off(mapped(c.values).mean(), 0, c.values);
  }
  return records;
}

}  // namespace diagnosis
