#include "host_sim/data_check/rig/rig_balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/data_check/drive/work.hpp"
#include "host_sim/data_check/measures/unit_factors.hpp"
#include "host_sim/data_check/rig/balance.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kFewestBells = 60.0;  // in a record
constexpr double kUnexplained = 0.5;   // of the force (the inertia where there is none), before
constexpr double kExplained = 0.1;     // and after the change
constexpr double kRivals = 2.0;        // the next best change leaves at least this many times more

struct Change {
  std::vector<size_t> channels;  // one, or all motion
  double times = 1.0;            // their values
  std::string unit;              // empty: turned over
  double left = 1.0;
};

Dimension dimension_of_channel(const Channel& channel) {
  const auto name = rig_file::parse_channel_name(channel.name);
  return dimension_of(static_cast<firmware::Quantity>(channel.quantity), name && name->rotating);
}

std::vector<Change> changes_of(const std::vector<const Channel*>& channels) {
  std::vector<Change> changes;
  for (size_t i = 0; i < channels.size(); ++i) {
    changes.push_back({{i}, -1.0, "", 1.0});
    for (const char* word : {"g", "mm", "kN", "deg", "mm/s", "rpm", "mm/s2", "um", "cm", "inch", "lbf", "kgf", "mN",
                             "N mm", "mN m", "kN m"}) {
      const auto unit = find_unit(word, dimension_of_channel(*channels[i]));
      if (unit && unit->dimension == dimension_of_channel(*channels[i]))
        changes.push_back({{i}, unit->to_si, word, 1.0});
    }
  }
  return changes;
}

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

std::vector<double> multipliers(size_t count, const Change& change) {
  std::vector<double> times(count, 1.0);
  for (const size_t channel : change.channels) times[channel] = change.times;
  return times;
}

std::string names_of(const Change& change, const std::vector<const Channel*>& channels) {
  if (change.channels.size() == 1) return channels[change.channels.front()]->name;
  return "all motion channels";
}

// Two changes that say the same of the equations, such as force in kN and motion in mm.
bool same_statement(const Change& a, const Change& b) { return std::abs(std::log(a.left / b.left)) < 0.05; }

// Then its sign is changed on the way in, as where it takes energy all the time (work.hpp).
bool is_only_force(const std::vector<const Channel*>& channels, const Change& change) {
  if (change.channels.size() != 1 || channels[change.channels.front()]->quantity != Quantity::kForce) return false;
  return std::count_if(channels.begin(), channels.end(),
                       [](const Channel* c) { return c->quantity == Quantity::kForce; }) == 1;
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
  for (size_t i = 1; i < changes.size(); ++i) {
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
  if (best.unit.empty() && or_else.empty() && is_only_force(channels, best)) {
    finding.weight = Weight::kDoubt;
    finding.detail += std::string("; ") + kSignIsChanged;
  }
  return {finding};
}

// The record with the motion channels of two DOFs exchanged.
Record with_exchanged(const Record& record, int i, int j) {
  Record other = record;
  for (Channel& channel : other.channels) {
    if (channel.quantity == Quantity::kForce || (channel.dof != i && channel.dof != j)) continue;
    channel.values = record.find(channel.quantity, channel.dof == i ? j : i)->values;
  }
  return other;
}

// Both DOFs have one motion channel, of one quantity. (Several channels of a DOF that all went to the other are less
// likely than a rig file that lacks something; one of several is told by its fellows, exchanged.hpp.)
bool can_be_exchanged(const Record& record, int i, int j) {
  const Channel *of_i = nullptr, *of_j = nullptr;
  for (const Channel& channel : record.channels) {
    if (channel.quantity == Quantity::kForce || (channel.dof != i && channel.dof != j)) continue;
    const Channel*& place = channel.dof == i ? of_i : of_j;
    if (place != nullptr) return false;
    place = &channel;
  }
  return of_i != nullptr && of_j != nullptr && dimension_of_channel(*of_i) == dimension_of_channel(*of_j);
}

// Lone channels of two DOFs exchanged: told by the same limits as a turned or foreign one.
std::vector<Finding> exchanged_dofs(const Record& record, const rig_file::RigModel& model, size_t h, double before) {
  if (!(before > kUnexplained)) return {};
  int best_i = 0, best_j = 0;
  double best = 1e300, next = 1e300;
  const int dofs = static_cast<int>(model.dofs.size());
  for (int i = 1; i <= dofs; ++i)
    for (int j = i + 1; j <= dofs; ++j) {
      if (!can_be_exchanged(record, i, j)) continue;
      const Record other = with_exchanged(record, i, j);
      Balance balance(other, model);
      const std::vector<Equation> equations = balance.equations(h);
      if (equations.empty()) continue;
      const double left = unexplained(equations, std::vector<double>(balance.channels().size(), 1.0));
      next = std::min(next, std::max(left, best));
      if (left < best) best = left, best_i = i, best_j = j;
    }
  if (!(best < kExplained) || !(best < 0.25 * before) || next < kRivals * best) return {};
  std::vector<Finding> findings;
  for (const Channel& channel : record.channels) {
    if (channel.quantity == Quantity::kForce || channel.dof != best_i) continue;
    std::string text = fmt::format(
        ": the rig file's masses and springs explain {:.0f} % of the motion so, and {:.0f} % as it stands; exchange "
        "the columns, or the DOFs' numbers in the rig file",
        100.0 * (1.0 - best), 100.0 * std::max(0.0, 1.0 - before));
    findings.push_back({"exchanged", Weight::kFault, channel.name,
                        "is exchanged with " + record.find(channel.quantity, best_j)->name + text, best});
  }
  return findings;
}

}  // namespace

std::vector<Finding> check_rig_balance(const Record& record, const rig_file::RigModel& model) {
  Balance balance(record, model);
  std::vector<Change> possible = changes_of(balance.channels()), best;
  add_common_changes(balance.channels(), possible);
  double best_before = 0.0, best_left = 1e300;
  size_t best_h = 0;
  for (size_t h = 2; static_cast<double>(record.samples()) > kFewestBells * static_cast<double>(6 * h); h *= 2) {
    const std::vector<Equation> equations = balance.equations(h);
    if (equations.empty()) continue;
    std::vector<Change> changes = possible;
    const double before = unexplained(equations, std::vector<double>(balance.channels().size(), 1.0));
    double least = before;
    for (Change& change : changes) {
      change.left = unexplained(equations, multipliers(balance.channels().size(), change));
      least = std::min(least, change.left);
    }
    if (least >= best_left) continue;
    best_left = least;
    best_before = before;
    best_h = h;
    best = std::move(changes);
  }
  if (best.empty()) return {};
  std::vector<Finding> findings = findings_of(std::move(best), balance.channels(), best_before);
  return findings.empty() ? exchanged_dofs(record, model, best_h, best_before) : findings;
}

}  // namespace host_sim::data_check
