#include "host_sim/data_check/rig_balance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/data_check/bell.hpp"
#include "host_sim/data_check/unit_factors.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kFewestBells = 60.0;  // in a record
constexpr double kUnexplained = 0.5;   // of the force (the inertia where there is none), before
constexpr double kExplained = 0.1;     // and after the change
constexpr double kRivals = 2.0;        // the next best change leaves at least this many times more
constexpr double kTellsApart = 0.1;    // smallest singular value but one, of columns of unit length

// A channel that the balance uses: the lowest derivative that the DOF has, or its force.
struct Used {
  const Channel* channel = nullptr;
  int order = 0;  // 0 displacement, 1 velocity, 2 acceleration; of a force the equation's own
};

// The equation of one DOF: columns whose sum vanishes, one for each channel's known part, what friction and unknown
// coefficients explain taken off.
struct Equation {
  std::vector<size_t> channel;  // of each column: index into the balance's channels
  Eigen::MatrixXd columns;
  double reference = 0.0;  // squares of the force, or of the inertia where no force acts
  size_t reference_channel = 0;
};

class Balance {
 public:
  Balance(const Record& record, const rig_file::RigModel& model) : record_(record), model_(model) {
    for (int dof = 1; dof <= static_cast<int>(model.dofs.size()); ++dof) take_motion(dof);
    for (const rig_file::Link& link : model.links)
      if (link.b == rig_file::kBase && motion_.count(rig_file::kBase) == 0) take_motion(rig_file::kBase);
    for (const auto& [dof, used] : motion_) differentiate_ = std::max(differentiate_, used.order);
    for (const Channel& channel : record.channels)
      if (channel.quantity == Quantity::kForce && is_moving(channel)) {
        force_[channel.dof] = channels_.size();
        channels_.push_back(&channel);
      }
  }

  std::vector<Equation> equations(size_t h) const {
    std::vector<Equation> result;
    for (int dof = 1; dof <= static_cast<int>(model_.dofs.size()); ++dof) {
      Equation equation = equation_of(dof, h);
      if (equation.columns.cols() >= 2 && tells_apart(equation)) result.push_back(std::move(equation));
    }
    return result;
  }
  const std::vector<const Channel*>& channels() const { return channels_; }

 private:
  static bool is_moving(const Channel& channel) {
    return std::any_of(channel.values.begin(), channel.values.end(),
                       [&](double value) { return value != channel.values.front(); });
  }

  void take_motion(int dof) {
    for (const Quantity quantity : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
      if (const Channel* channel = record_.find(quantity, dof); channel != nullptr && is_moving(*channel)) {
        motion_[dof] = {channel, static_cast<int>(quantity) - static_cast<int>(Quantity::kDisplacement)};
        place_[dof] = channels_.size();
        channels_.push_back(channel);
        return;
      }
  }

  // The order-th derivative of the DOF's displacement, as much further differentiated as all of the equation is; every
  // h-th value.
  Eigen::VectorXd column(int dof, int order, size_t h) const {
    const Used& used = motion_.at(dof);
    return thinned(bell(used.channel->values, differentiate_ + order - used.order, h, record_.sample_period_s), h);
  }
  static Eigen::VectorXd thinned(const std::vector<double>& values, size_t h) {
    Eigen::VectorXd out(static_cast<Eigen::Index>(values.size() / h));
    for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = values[static_cast<size_t>(i) * h];
    return out.array() - out.mean();
  }

  Equation equation_of(int dof, size_t h) const {
    Equation equation;
    const rig_file::Dof& body = model_.dofs[static_cast<size_t>(dof - 1)];
    if (motion_.count(dof) == 0 || !body.effects.empty()) return equation;
    std::vector<Eigen::VectorXd> known, free = {column(dof, 1, h)};
    const auto add = [&](size_t channel, Eigen::VectorXd values) {
      equation.channel.push_back(channel);
      known.push_back(std::move(values));
    };
    if (body.mass_kg.estimate) {
      free.push_back(column(dof, 2, h));
    } else if (body.mass_kg.value > 0.0) {
      add(place_.at(dof), body.mass_kg.value * column(dof, 2, h));
    }
    std::map<int, double> spring;  // by DOF: what its displacement is multiplied with
    for (const rig_file::Link& link : model_.links) {
      if (link.a != dof && link.b != dof) continue;
      const int other = link.a == dof ? link.b : link.a;
      if (!link.effects.empty() || link.gravity_torque_N_m.estimate || link.gravity_torque_N_m.value != 0.0 ||
          (other != rig_file::kGround && motion_.count(other) == 0))
        return Equation();
      for (const int end : {dof, other}) {
        if (end == rig_file::kGround) continue;
        if (end != dof) free.push_back(column(end, 1, h));
        if (link.stiffness_N_m.estimate) {
          free.push_back(column(end, 0, h));
        } else if (link.stiffness_N_m.value > 0.0) {
          spring[end] += (end == dof ? 1.0 : -1.0) * link.stiffness_N_m.value;
        }
      }
    }
    for (const auto& [end, stiffness] : spring) add(place_.at(end), stiffness * column(end, 0, h));
    if (force_.count(dof) > 0) {
      equation.reference_channel = force_.at(dof);
      const Channel& force = *channels_[force_.at(dof)];
      add(force_.at(dof), -thinned(bell(force.values, differentiate_, h, record_.sample_period_s), h));
    } else {
      equation.reference_channel = place_.at(dof);
    }
    project(known, free, equation);
    return equation;
  }

  // Takes what the free columns explain off the known ones.
  static void project(const std::vector<Eigen::VectorXd>& known, const std::vector<Eigen::VectorXd>& free,
                      Equation& equation) {
    if (known.size() < 2 || known.front().size() < 4 * static_cast<Eigen::Index>(free.size() + known.size())) return;
    const Eigen::Index rows = known.front().size();
    Eigen::MatrixXd nuisance(rows, static_cast<Eigen::Index>(free.size()));
    for (size_t i = 0; i < free.size(); ++i)
      nuisance.col(static_cast<Eigen::Index>(i)) = free[i] / std::max(free[i].norm(), 1e-300);
    equation.columns.resize(rows, static_cast<Eigen::Index>(known.size()));
    for (size_t i = 0; i < known.size(); ++i) equation.columns.col(static_cast<Eigen::Index>(i)) = known[i];
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(nuisance);
    equation.columns -= nuisance * solver.solve(equation.columns);
    for (size_t i = 0; i < known.size(); ++i)
      if (equation.channel[i] == equation.reference_channel)
        equation.reference =
            std::max(equation.reference, equation.columns.col(static_cast<Eigen::Index>(i)).squaredNorm());
  }

  // One relation among the columns is the equation itself; a second one means that they cannot be told apart.
  static bool tells_apart(const Equation& equation) {
    if (!(equation.reference > 0.0)) return false;
    Eigen::MatrixXd unit = equation.columns;
    for (Eigen::Index i = 0; i < unit.cols(); ++i) {
      const double norm = unit.col(i).norm();
      if (!(norm > 0.0)) return false;
      unit.col(i) /= norm;
    }
    const Eigen::VectorXd values = unit.jacobiSvd().singularValues();
    return values[values.size() - 2] > kTellsApart;
  }

  const Record& record_;
  const rig_file::RigModel& model_;
  std::vector<const Channel*> channels_;
  std::map<int, Used> motion_;           // by DOF
  std::map<int, size_t> place_, force_;  // index into channels_, by DOF
  int differentiate_ = 0;
};

// The share of the reference that is not explained when each channel's values are multiplied so: the worst equation's.
double unexplained(const std::vector<Equation>& equations, const std::vector<double>& times) {
  double worst = 0.0;
  for (const Equation& equation : equations) {
    Eigen::VectorXd weights(equation.columns.cols());
    for (Eigen::Index i = 0; i < weights.size(); ++i) weights[i] = times[equation.channel[static_cast<size_t>(i)]];
    const double reference = equation.reference * std::pow(times[equation.reference_channel], 2);
    worst = std::max(worst, (equation.columns * weights).squaredNorm() / reference);
  }
  return worst;
}

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
  char share[120];
  std::snprintf(share, sizeof share,
                "the rig file's masses and springs explain %.0f %% of the motion so, and %.0f %% as it stands",
                100.0 * (1.0 - best.left), 100.0 * std::max(0.0, 1.0 - before));
  Finding finding{best.unit.empty() ? "polarity" : "unit", Weight::kFault, channels[best.channels.front()]->name, "",
                  best.times};
  finding.detail = (best.channels.size() > 1 ? "and all other motion channels are in " + best.unit
                    : best.unit.empty()      ? std::string("is turned over")
                                             : "is in " + best.unit) +
                   or_else + ": " + share;
  return {finding};
}

}  // namespace

std::vector<Finding> check_rig_balance(const Record& record, const rig_file::RigModel& model) {
  const Balance balance(record, model);
  std::vector<Change> best;
  double best_before = 0.0, best_left = 1e300;
  for (size_t h = 2; static_cast<double>(record.samples()) > kFewestBells * static_cast<double>(6 * h); h *= 2) {
    const std::vector<Equation> equations = balance.equations(h);
    if (equations.empty()) continue;
    std::vector<Change> changes = changes_of(balance.channels());
    add_common_changes(balance.channels(), changes);
    const double before = unexplained(equations, std::vector<double>(balance.channels().size(), 1.0));
    double least = before;
    for (Change& change : changes) {
      change.left = unexplained(equations, multipliers(balance.channels().size(), change));
      least = std::min(least, change.left);
    }
    if (least >= best_left) continue;
    best_left = least;
    best_before = before;
    best = std::move(changes);
  }
  if (best.empty()) return {};
  return findings_of(std::move(best), balance.channels(), best_before);
}

}  // namespace host_sim::data_check
