#include "along_motion.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/vocabulary/held_in_place.hpp"
#include "motion/prepared.hpp"
#include "record/motion.hpp"
#include "terms/naming.hpp"

namespace diagnosis {
namespace {

// Of the motion or of the force, on unseen data: beyond it nothing is followed, and nothing is known of the forces.
constexpr double kFollowed_percent = 25;
constexpr double kHalf = 0.5;  // of what free runs miss of the motion, may be missed of the force

bool astray(const Diagnosis& d) {
  return (d.verdict == Verdict::kUnknown && d.causes.empty()) ||
         (d.more_remains && d.extended.most_missed_percent() > kFollowed_percent);
}

// A simulation that a spring holds swings against the motion at worst, and misses twice of it. What misses more has run away.
constexpr double kRunsAway_percent = 200;

// Gravity holds what hangs. What stands on it falls in a simulation, to either side.
rig_file::RigModel without_gravity(rig_file::RigModel rig) {
  for (rig_file::Link& link : rig.links) {
    link.gravity_torque_N_m = {};
    const auto gravity = [](const rig_file::Effect& e) { return e.kind == word_of(Kind::kGravity); };
    link.effects.erase(std::remove_if(link.effects.begin(), link.effects.end(), gravity), link.effects.end());
  }
  return rig;
}

// By springs, or by gravity that keeps its simulation near what was measured.
bool held(const rig_file::RigModel& rig, const Diagnosis& free_runs) {
  if (!vocabulary::held_in_place(rig)) return false;
  return vocabulary::held_in_place(without_gravity(rig)) ||
         free_runs.extended.most_missed_percent() < kRunsAway_percent;
}

bool every_force_is_measured(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records) {
  return std::all_of(records.begin(), records.end(), [&](const host_sim::Record& record) {
    for (size_t d = 0; d < rig.dofs.size(); ++d)
      if (!record.find(host_sim::Quantity::kForce, static_cast<int>(d) + 1)) return false;
    return true;
  });
}

// A mass that the rig file leaves open is fitted with the forces, as an error of no mass: it is no cause, and need not take as much as one.
rig_file::Effect open_mass() { return {word_of(Kind::kMassError), {0, true}, {}}; }

// Of each DOF without its mass.
rig_file::RigModel without_masses(rig_file::RigModel rig) {
  for (rig_file::Dof& dof : rig.dofs) {
    if (dof.mass_kg.estimate) dof.effects.push_back(open_mass());
    dof.mass_kg = {0, false};
  }
  return rig;
}

// Of each DOF, kg or kg m^2: as the rig file has it; nought where it leaves it open.
std::vector<double> known_masses(const rig_file::RigModel& rig) {
  std::vector<double> masses;
  for (const rig_file::Dof& dof : rig.dofs) masses.push_back(dof.mass_kg.estimate ? 0.0 : dof.mass_kg.value);
  return masses;
}

void give_masses_back(const rig_file::RigModel& asked, rig_file::RigModel& rig) {
  const auto is_open_mass = [](const rig_file::Effect& e) { return e.kind == open_mass().kind; };
  for (size_t i = 0; i < asked.dofs.size(); ++i) {
    std::vector<rig_file::Effect>& effects = rig.dofs[i].effects;
    rig.dofs[i].mass_kg = asked.dofs[i].mass_kg;
    if (asked.dofs[i].mass_kg.estimate)
      effects.erase(std::remove_if(effects.begin(), effects.end(), is_open_mass), effects.end());
  }
}

// The errors of no mass under the masses' own names, first as everywhere. What is fitted beside a force that is missing may be bent.
void rename_masses(const rig_file::RigModel& asked, std::vector<Parameter>& parameters) {
  auto first = parameters.begin();
  for (size_t i = 0; i < asked.dofs.size(); ++i) {
    const std::string place = "[" + std::to_string(i + 1) + "]";
    const auto mass = std::find_if(parameters.begin(), parameters.end(),
                                   [&](const Parameter& p) { return p.name == open_mass().kind + place; });
    if (!asked.dofs[i].mass_kg.estimate || mass == parameters.end()) continue;
    mass->name = "mass" + place, mass->may_be_bent = true, mass->undetermined |= mass->value <= 0;
    std::rotate(first, mass, mass + 1), ++first;
  }
}

// Less what the masses take of each force. The acceleration was thinned out: between its samples it is a straight line.
host_sim::Record without_inertia(host_sim::Record record, const runs::Prepared& p, const std::vector<double>& masses) {
  for (host_sim::Channel& c : record.channels) {
    if (c.quantity != host_sim::Quantity::kForce || c.dof < 1) continue;
    const size_t dof = static_cast<size_t>(c.dof - 1);
    const runs::Vec& a = p.guess[dof].a;
    for (size_t i = 0; i < c.values.size(); ++i) {
      const double at = static_cast<double>(i) * record.sample_period_s / p.step_s,
                   last = static_cast<double>(a.size() - 1);
      const auto before = static_cast<Eigen::Index>(std::min(at, last));
      const Eigen::Index next = std::min(before + 1, a.size() - 1);
      const double share = std::min(1.0, at - static_cast<double>(before));
      c.values[i] -= masses[dof] * ((1 - share) * a[before] + share * a[next]);
    }
  }
  return record;
}

// What is said of the forces along the motion, less what the known masses take.
Diagnosis told_along(const Asked& asked, Diagnosis (*judge)(const Asked&)) {
  const std::vector<runs::Prepared> prepared = runs::prepare_all(asked.rig, asked.training, asked.holdout);
  const rig_file::RigModel rig = without_masses(asked.rig);
  const std::vector<double> masses = known_masses(asked.rig);
  std::vector<host_sim::Record> training, holdout;
  for (size_t i = 0; i < prepared.size(); ++i) {
    const bool fitted = i < asked.training.size();
    const host_sim::Record& record = fitted ? asked.training[i] : asked.holdout[i - asked.training.size()];
    (fitted ? training : holdout).push_back(without_inertia(record, prepared[i], masses));
  }
  const Options silent{asked.options.top_of_band, nullptr};
  Diagnosis d = judge({rig, training, holdout, silent, asked.ground_known});
  give_masses_back(asked.rig, d.extended_rig);
  for (ModelScore* score : {&d.baseline, &d.extended}) rename_masses(asked.rig, score->parameters);
  d.along_motion = true;
  return d;
}

double most_gained(const Diagnosis& d) {
  return d.gain.empty() ? 1.0 : *std::max_element(d.gain.begin(), d.gain.end());
}

// The forces are followed, or what is named leaves half of them: what else there is may be the force's noise. What is known of forces that
// are followed, though something is missing in them, is more than free runs say that name nothing.
bool tells(const Diagnosis& d, const Diagnosis& free_runs) {
  if (!d.cannot_describe.empty()) return false;
  if (d.verdict == Verdict::kUnknown && !free_runs.causes.empty()) return false;
  if (free_runs.determines_nothing && d.causes.empty()) return false;  // the same records, and nothing seen in them
  const double most = std::min(kFollowed_percent, kHalf * free_runs.extended.most_missed_percent());
  return d.extended.most_missed_percent() < most || (!d.causes.empty() && most_gained(d) > 1 / kHalf);
}

}  // namespace

Diagnosis judged_along_the_motion(const Asked& asked, Diagnosis (*judge)(const Asked&)) {
  const Diagnosis free_runs = judge(asked);
  if (!astray(free_runs) || runs::massless(asked.rig) || held(asked.rig, free_runs) ||
      !every_force_is_measured(asked.rig, asked.training) || !every_force_is_measured(asked.rig, asked.holdout))
    return free_runs;
  try {
    const Diagnosis d = told_along(asked, judge);
    return tells(d, free_runs) ? d : free_runs;
  } catch (const CannotAnswer&) {
    return free_runs;
  }
}

}  // namespace diagnosis
