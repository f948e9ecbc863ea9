#include "host_sim/programs/shared/rest_position.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "host_sim/programs/shared/any_force.hpp"
#include "host_sim/programs/shared/weighs.hpp"

namespace host_sim {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kOneSide = 2.0;  // rms about the mean: a sine whose mean is 1.4 of it just touches zero
constexpr double kOff = 0.02;     // of the rms: three periods of a decay tell where it rests to 0.3 % of its amplitude

struct Moments {
  double mean = 0, rms = 0;
};

Moments moments(const std::vector<Record>& records, size_t channel) {
  double sum = 0, squares = 0, count = 0;
  for (const Record& record : records)
    for (double value : record.channels[channel].values) sum += value, count += 1;
  if (count == 0) return {};
  const double mean = sum / count;
  for (const Record& record : records)
    for (double value : record.channels[channel].values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / count)};
}

// Gravity pulls to where the angle is zero, whatever the mean: a driven arm need not swing about there. Left alone it comes to rest.
bool is_held_off(const rig_file::RigModel& model, const Record& record, int dof) {
  return any_force(record) && std::any_of(model.links.begin(), model.links.end(),
                                          [&](const rig_file::Link& link) { return weighs(link) && link.a == dof; });
}

// Where a rig that nothing drives rests: the mean of its displacement, weighted with the square of its speed, so that what stands
// still does not count, and with a bell over the record, so that parts of a period at its ends do not.
class Rest {
 public:
  void add(const std::vector<double>& y) {
    for (size_t k = 1; k + 1 < y.size(); ++k) {
      const double bell = std::sin(kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(y.size()));
      const double weight = bell * bell * (y[k + 1] - y[k - 1]) * (y[k + 1] - y[k - 1]);
      sum_ += weight * y[k], squares_ += weight * y[k] * y[k], weights_ += weight;
    }
  }
  Moments moments() const {
    if (!(weights_ > 0)) return {};
    const double mean = sum_ / weights_;
    return {mean, std::sqrt(std::max(0.0, squares_ / weights_ - mean * mean))};
  }

 private:
  double sum_ = 0, squares_ = 0, weights_ = 0;
};

Moments about_rest(const std::vector<Record>& records, size_t channel) {
  Rest rest;
  for (const Record& record : records) rest.add(record.channels[channel].values);
  return rest.moments();
}

// Laws that tell one direction from the other, or a base that moves: the mean is then no place of rest.
bool rests_at_its_mean(const rig_file::RigModel& model, const Record& record) {
  if (any_force(record)) return false;
  for (const Channel& channel : record.channels)
    if (channel.dof == rig_file::kBase) return false;
  for (const rig_file::Link& link : model.links)
    for (const rig_file::Effect& e : link.effects)
      if (e.kind == "quadratic_stiffness" || e.kind == "force_offset" || e.kind == "asymmetric_viscous") return false;
  return true;
}

// Where each record of a free rig rests, where they do not rest alike: a zero that was set anew, a string that was hung up again. Empty
// where they do.
std::vector<double> own_rests(const std::vector<Record>& records, size_t channel) {
  if (records.size() == 1) return {};
  std::vector<double> rests;
  double largest = 0;
  for (const Record& record : records) {
    Rest rest;
    rest.add(record.channels[channel].values);
    const Moments own = rest.moments();
    rests.push_back(own.mean), largest = std::max(largest, own.rms);
  }
  const auto [least, most] = std::minmax_element(rests.begin(), rests.end());
  return *most - *least > kOff * largest ? rests : std::vector<double>{};
}

std::string said_of_rests(const std::string& name, const std::vector<double>& rests) {
  std::vector<std::string> places;
  for (double rest : rests) places.push_back(fmt::format("{:.4g}", rest));
  return fmt::format("{} swings about {}, record by record: each counted from its own, as the position of rest", name,
                     fmt::join(places, ", "));
}

}  // namespace

CountedFromRest count_from_rest(const rig_file::RigModel& model, SharedRecords& records) {
  CountedFromRest rest;
  if (records.get().empty()) return rest;
  const bool free = rests_at_its_mean(model, records.get().front());
  for (size_t c = 0; c < records.get().front().channels.size(); ++c) {
    if (records.get().front().channels[c].quantity != Quantity::kDisplacement) continue;
    if (is_held_off(model, records.get().front(), records.get().front().channels[c].dof)) continue;
    const std::string& name = records.get().front().channels[c].name;
    const std::vector<double> rests = free ? own_rests(records.get(), c) : std::vector<double>{};
    for (size_t r = 0; r < rests.size(); ++r)
      for (double& value : records.own()[r].channels[c].values) value -= rests[r];
    if (!rests.empty()) {
      rest.notes.push_back(said_of_rests(name, rests));
      continue;
    }
    const Moments all = moments(records.get(), c), swing = free ? about_rest(records.get(), c) : all;
    const bool one_side = std::fabs(all.mean) > kOneSide * all.rms;
    if (!one_side && !(free && std::fabs(swing.mean) > kOff * swing.rms)) continue;
    for (Record& record : records.own())
      for (double& value : record.channels[c].values) value -= swing.mean;
    if (!free) rest.held_off.push_back(c);
    rest.notes.push_back(
        one_side
            ? fmt::format("{} never comes to its zero: counted from its mean, {:.4g}, as the position of rest", name,
                          swing.mean)
            : fmt::format("{} swings about {:.4g}: counted from there, as the position of rest", name, swing.mean));
  }
  return rest;
}

}  // namespace host_sim
