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

bool every_force_is_measured(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records) {
  return std::all_of(records.begin(), records.end(), [&](const host_sim::Record& record) {
    for (size_t d = 0; d < rig.dofs.size(); ++d)
      if (!record.find(host_sim::Quantity::kForce, static_cast<int>(d) + 1)) return false;
    return true;
  });
}

struct Mass {
  double of = 0, std = 0;  // kg or kg m^2
};

// Of each DOF: as the rig file has it; nought where it leaves it open.
std::vector<Mass> masses_of(const rig_file::RigModel& rig) {
  std::vector<Mass> masses;
  for (const rig_file::Dof& dof : rig.dofs) masses.push_back({dof.mass_kg.estimate ? 0.0 : dof.mass_kg.value, 0});
  return masses;
}

// Beside no mass a mass error is the mass that the rig file leaves open. True where one is named that the masses have not.
bool take_masses(const rig_file::RigModel& rig, const Diagnosis& d, std::vector<Mass>& masses) {
  bool any = false;
  for (size_t i = 0; i < rig.dofs.size(); ++i)
    for (const Cause& c : d.causes)
      if (rig.dofs[i].mass_kg.estimate && c.effect == word_of(Kind::kMassError) &&
          c.where == "dof " + std::to_string(i + 1) && !c.parameters.empty() && c.parameters[0].value > 0)
        masses[i] = {c.parameters[0].value, c.parameters[0].std}, any = true;
  return any;
}

// What is known of the masses that the rig file leaves open: what stands above nought was fitted beside another force.
void add_masses(const rig_file::RigModel& rig, const std::vector<Mass>& masses, Diagnosis& d) {
  for (size_t i = rig.dofs.size(); i-- > 0;) {
    if (!rig.dofs[i].mass_kg.estimate) continue;
    Parameter mass{"mass[" + std::to_string(i + 1) + "]", masses[i].of, unit_of(Kind::kMass, rig.dofs[i].rotating)};
    mass.std = masses[i].std, mass.undetermined = masses[i].of <= 0, mass.may_be_bent = true;
    for (ModelScore* score : {&d.baseline, &d.extended}) score->parameters.insert(score->parameters.begin(), mass);
  }
}

// Less what the masses take of each force. The acceleration was thinned out: between its samples it is a straight line.
host_sim::Record without_inertia(host_sim::Record record, const runs::Prepared& p, const std::vector<Mass>& masses) {
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
      c.values[i] -= masses[dof].of * ((1 - share) * a[before] + share * a[next]);
    }
  }
  return record;
}

// What is said of the forces along the motion, less what these masses take.
Diagnosis told_along(const Asked& asked, const std::vector<runs::Prepared>& prepared, const std::vector<Mass>& masses,
                     Diagnosis (*judge)(const Asked&)) {
  rig_file::RigModel rig = asked.rig;
  for (rig_file::Dof& dof : rig.dofs) dof.mass_kg = {0, false};
  std::vector<host_sim::Record> training, holdout;
  for (size_t i = 0; i < prepared.size(); ++i) {
    const bool fitted = i < asked.training.size();
    const host_sim::Record& record = fitted ? asked.training[i] : asked.holdout[i - asked.training.size()];
    (fitted ? training : holdout).push_back(without_inertia(record, prepared[i], masses));
  }
  const Options silent{asked.options.top_of_band, nullptr};
  Diagnosis d = judge({rig, training, holdout, silent, asked.ground_known});
  for (size_t i = 0; i < asked.rig.dofs.size(); ++i) d.extended_rig.dofs[i].mass_kg = asked.rig.dofs[i].mass_kg;
  add_masses(asked.rig, masses, d);
  d.along_motion = true;
  return d;
}

double most_gained(const Diagnosis& d) {
  return d.gain.empty() ? 1.0 : *std::max_element(d.gain.begin(), d.gain.end());
}

// The forces are followed, or what is named leaves half of them: what else there is may be the force's noise.
bool tells(const Diagnosis& d, const Diagnosis& free_runs) {
  if (d.verdict == Verdict::kUnknown || !d.cannot_describe.empty()) return false;
  const double most = std::min(kFollowed_percent, kHalf * free_runs.extended.most_missed_percent());
  return d.extended.most_missed_percent() < most || (!d.causes.empty() && most_gained(d) > 1 / kHalf);
}

}  // namespace

Diagnosis judged_along_the_motion(const Asked& asked, Diagnosis (*judge)(const Asked&)) {
  const Diagnosis free_runs = judge(asked);
  if (!astray(free_runs) || runs::massless(asked.rig) || vocabulary::held_in_place(asked.rig) ||
      !every_force_is_measured(asked.rig, asked.training) || !every_force_is_measured(asked.rig, asked.holdout))
    return free_runs;
  try {
    const std::vector<runs::Prepared> prepared = runs::prepare_all(asked.rig, asked.training, asked.holdout);
    std::vector<Mass> masses = masses_of(asked.rig);
    Diagnosis d = told_along(asked, prepared, masses, judge);
    if (take_masses(asked.rig, d, masses)) d = told_along(asked, prepared, masses, judge);
    return tells(d, free_runs) ? d : free_runs;
  } catch (const CannotAnswer&) {
    return free_runs;
  }
}

}  // namespace diagnosis
