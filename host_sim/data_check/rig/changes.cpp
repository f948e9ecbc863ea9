#include "host_sim/data_check/rig/changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/data_check/drive/one_sign.hpp"

namespace host_sim::data_check {
namespace {

// All motion channels in one unit, where they are all of one quantity.
void add_common_changes(const std::vector<const Channel*>& channels, std::vector<Change>& changes) {
  std::vector<size_t> motion;
  for (size_t i = 0; i < channels.size(); ++i)
    if (channels[i]->quantity != Quantity::kForce) motion.push_back(i);
  if (motion.size() < 2) return;
  for (const size_t i : motion)
    if (dimension_of_channel(*channels[i]) != dimension_of_channel(*channels[motion.front()])) return;
  for (size_t c = 0, single = changes.size(); c < single; ++c)
    if (changes[c].channels.front() == motion.front() && !changes[c].unit.empty())
      changes.push_back({motion, changes[c].times, changes[c].unit, 1.0});
}

std::string names_of(const Change& change, const std::vector<const Channel*>& channels) {
  if (change.channels.size() == 1) return channels[change.channels.front()]->name;
  return "all motion channels";
}

// Another motion channel of its DOF: they have been found to agree, so none of them is turned over alone.
bool has_a_witness(const Channel& channel, const std::vector<const Channel*>& channels) {
  return channel.quantity != Quantity::kForce &&
         std::any_of(channels.begin(), channels.end(), [&](const Channel* other) {
           return other != &channel && other->dof == channel.dof && other->quantity != Quantity::kForce;
         });
}

// The only motion that is measured: to turn it over or the force is one and the same.
bool is_only_motion(const std::vector<const Channel*>& channels, const Change& change) {
  return change.channels.size() == 1 && channels[change.channels.front()]->quantity != Quantity::kForce &&
         std::count_if(channels.begin(), channels.end(),
                       [](const Channel* c) { return c->quantity != Quantity::kForce; }) == 1;
}

// Two changes that say the same of the equations, such as force in kN and motion in mm.
bool same_statement(const Change& a, const Change& b) { return std::abs(std::log(a.left / b.left)) < 0.05; }

// Then its sign is changed on the way in, as where it takes energy all the time (drive/one_sign.hpp).
bool is_only_force(const std::vector<const Channel*>& channels, const Change& change) {
  if (change.channels.size() != 1 || channels[change.channels.front()]->quantity != Quantity::kForce) return false;
  return std::count_if(channels.begin(), channels.end(),
                       [](const Channel* c) { return c->quantity == Quantity::kForce; }) == 1;
}

}  // namespace

Dimension dimension_of_channel(const Channel& channel) {
  const auto name = rig_file::parse_channel_name(channel.name);
  return dimension_of(static_cast<firmware::Quantity>(channel.quantity), name && name->rotating);
}

std::vector<Change> changes_of(const std::vector<const Channel*>& channels) {
  std::vector<Change> changes;
  for (size_t i = 0; i < channels.size(); ++i) {
    if (!has_a_witness(*channels[i], channels)) changes.push_back({{i}, -1.0, "", 1.0});
    for (const char* word : {"g", "mm", "kN", "deg", "mm/s", "rpm", "mm/s2", "um", "cm", "inch", "lbf", "kgf", "mN",
                             "N mm", "mN m", "kN m"}) {
      const auto unit = find_unit(word, dimension_of_channel(*channels[i]));
      if (unit && unit->dimension == dimension_of_channel(*channels[i]))
        changes.push_back({{i}, unit->to_si, word, 1.0});
    }
  }
  add_common_changes(channels, changes);
  return changes;
}

std::vector<double> multipliers(size_t count, const Change& change) {
  std::vector<double> times(count, 1.0);
  for (const size_t channel : change.channels) times[channel] = change.times;
  return times;
}

std::vector<Finding> findings_of(std::vector<Change> changes, const std::vector<const Channel*>& channels,
                                 double before) {
  std::sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) { return a.left < b.left; });
  // Of changes that say the same: the one that takes the fewest sensors to be wrong, and of those the force, because the
  // motion channels of a DOF have been found to agree.
  const auto simpler = [&](const Change& a, const Change& b) {
    if (a.channels.size() != b.channels.size()) return a.channels.size() < b.channels.size();
    const auto is_force = [&](const Change& c) { return channels[c.channels.front()]->quantity == Quantity::kForce; };
    return is_force(a) && !is_force(b);
  };
  for (size_t i = 1; i < changes.size() && same_statement(changes.front(), changes[i]); ++i)
    if (simpler(changes[i], changes.front())) std::swap(changes.front(), changes[i]);
  const Change& best = changes.front();
  if (!(before > kUnexplained) || !(best.left < kExplained) || !(best.left < 0.25 * before)) return {};
  std::string or_else;
  const bool of_sign = best.unit.empty() && is_only_force(channels, best);
  for (size_t i = 1; i < changes.size(); ++i) {
    if (of_sign && changes[i].unit.empty() && is_only_motion(channels, changes[i])) continue;
    if (same_statement(best, changes[i])) {
      or_else += ", or " + names_of(changes[i], channels) +
                 (changes[i].unit.empty()          ? " is turned over"
                  : changes[i].channels.size() > 1 ? " are in " + changes[i].unit
                                                   : " is in " + changes[i].unit);
    } else if (changes[i].left < kRivals * best.left) {
      return {};
    }
  }
  std::string share =
      fmt::format("the rig file's masses and springs explain {:.0f} % of the motion so, and {:.0f} % as it stands",
                  100.0 * (1.0 - best.left), 100.0 * std::max(0.0, 1.0 - before));
  Finding finding{best.unit.empty() ? "polarity" : "unit", Weight::kFault, channels[best.channels.front()]->name, "",
                  best.times};
  finding.detail = (best.channels.size() > 1 ? "and all other motion channels are in " + best.unit
                    : best.unit.empty()      ? std::string("is turned over")
                                             : "is in " + best.unit) +
                   or_else + ": " + share;
  if (of_sign && or_else.empty()) {
    finding.weight = Weight::kDoubt;
    finding.detail += std::string("; ") + kSignIsChanged;
  }
  return {finding};
}

}  // namespace host_sim::data_check
