#include "host_sim/programs/estimate/rest_position.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace host_sim {
namespace {

constexpr double kOneSide = 2.0;  // rms about the mean: a sine whose mean is 1.4 of it just touches zero

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
  const bool driven = std::any_of(record.channels.begin(), record.channels.end(),
                                  [](const Channel& c) { return c.quantity == Quantity::kForce; });
  const auto is_gravity = [](const rig_file::Effect& e) { return e.kind == "missing_gravity_torque"; };
  return driven && std::any_of(model.links.begin(), model.links.end(), [&](const rig_file::Link& link) {
           const bool weighs = link.gravity_torque_N_m.estimate || link.gravity_torque_N_m.value != 0 ||
                               std::any_of(link.effects.begin(), link.effects.end(), is_gravity);
           return weighs && link.a == dof;
         });
}

}  // namespace

std::vector<std::string> count_from_rest(const rig_file::RigModel& model, SharedRecords& records) {
  std::vector<std::string> notes;
  if (records.get().empty()) return notes;
  for (size_t c = 0; c < records.get().front().channels.size(); ++c) {
    if (records.get().front().channels[c].quantity != Quantity::kDisplacement) continue;
    if (is_held_off(model, records.get().front(), records.get().front().channels[c].dof)) continue;
    const Moments m = moments(records.get(), c);
    if (!(std::fabs(m.mean) > kOneSide * m.rms)) continue;
    for (Record& record : records.own())
      for (double& value : record.channels[c].values) value -= m.mean;
    notes.push_back(fmt::format("{} never comes to its zero: counted from its mean, {:.4g}, as the position of rest",
                                records.get().front().channels[c].name, m.mean));
  }
  return notes;
}

}  // namespace host_sim
