// From a record to what is simulated against it.
#include <algorithm>

#include "../band/band.hpp"
#include "../band/between_samples.hpp"
#include "../band/thinning.hpp"
#include "../record/motion.hpp"
#include "../record/riding.hpp"
#include "hal/rig_file/channel_entry.hpp"
#include "host_sim/records/steps/value_step.hpp"
#include "period.hpp"
#include "windowed_force.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kLevels = 5;  // of what a relay or a step switches between

bool driven(const Prepared& p) {
  const auto acts = [](const Vec& y) { return y.size() > 0 && y.cwiseAbs().maxCoeff() > 0; };
  return std::any_of(p.force.begin(), p.force.end(), acts) ||
         std::any_of(p.base.reading.begin(), p.base.reading.end(), acts);
}

// Only accelerations are known, and only against the base do they say where a DOF is.
bool rides_on_base(const rig_file::RigModel& rig, const Prepared& p) {
  return p.base.reading[2].size() > 0 && p.base.reading[0].size() + p.base.reading[1].size() == 0 &&
         !touches_ground(rig) &&
         std::all_of(p.traces.begin(), p.traces.end(), [](const MotionTrace& t) { return t.quantity == 2; });
}

// Of a decay: the mean of its last part, whose swings are the smallest.
double middle(const Vec& y) { return y.tail(std::max<Index>(1, y.size() / 5)).mean(); }

// A delay that the rig file states is no fault to be found.
Vec in_time(const rig_file::RigModel& rig, const host_sim::Record& record, const host_sim::Channel& c) {
  const double late_s = rig_file::stated_delay_s(rig, c.name);
  return late_s == 0 ? values_of(c) : delayed(values_of(c), -late_s / record.sample_period_s);
}

// A force of a few values is a command: its edges, however steep, are no noise.
bool switches(const Vec& force) {
  std::vector<double> levels;
  for (const double value : force) {
    if (std::find(levels.begin(), levels.end(), value) != levels.end()) continue;
    if (levels.size() == kLevels) return false;
    levels.push_back(value);
  }
  return true;
}

// A force, as noise in blows is told of it before it is thinned out.
void take_force(const rig_file::RigModel& rig, const host_sim::Record& record, const host_sim::Channel& c, int by,
                Prepared& p) {
  const Vec raw = in_time(rig, record, c);
  const Windowed f = massless(rig) ? Windowed{raw, {}, {}} : windowed(raw);
  const size_t d = static_cast<size_t>(c.dof - 1);
  p.force[d] = thinned(f.force, by);
  // as it was recorded: interpolation rounds the edges of a command
  p.noise_in_blows[d] = switches(values_of(c)) ? Vec::Zero(p.force[d].size()) : noise_in_blows(f, by);
}

void take_channels(const rig_file::RigModel& rig, const host_sim::Record& record, int by, Prepared& p) {
  const int n = static_cast<int>(rig.dofs.size());
  p.force.resize(rig.dofs.size()), p.noise_in_blows.resize(rig.dofs.size());
  for (const host_sim::Channel& c : record.channels) {
    const bool of_dof = c.dof >= 1 && c.dof <= n;
    if (c.quantity == host_sim::Quantity::kForce && of_dof) {
      take_force(rig, record, c, by, p);
      continue;
    }
    const int quantity = c.quantity == host_sim::Quantity::kDisplacement ? 0
                         : c.quantity == host_sim::Quantity::kVelocity   ? 1
                                                                         : 2;
    if (c.dof == rig_file::kBase)
      p.base.reading[static_cast<size_t>(quantity)] = thinned(in_time(rig, record, c), by);
    else if (of_dof)
      p.traces.push_back({c.dof - 1, quantity, c.name, thinned(in_time(rig, record, c), by), host_sim::value_step(c)});
  }
  for (const MotionTrace& t : p.traces) p.samples = t.y.size();
  for (MotionTrace& t : p.traces) t.travels = t.quantity == 0 && travels(t.y);
}

// Where nothing drives the motion its middle is free anyway: runs start from it, wherever the sensor has its zero.
void take_out_zeros(Prepared& p) {
  if (driven(p)) return;
  for (MotionTrace& t : p.traces)
    if (t.quantity == 0) t.y.array() -= middle(t.y);
}

Prepared thinned_out(const rig_file::RigModel& rig, const host_sim::Record& record, const Thinning& thinning) {
  Prepared p;
  p.file = record.file;
  p.step_s = record.sample_period_s * thinning.by;
  p.read_every_s = record.sample_period_s;
  p.top_Hz = thinning.top_Hz;
  take_channels(rig, record, thinning.by, p);
  take_out_zeros(p);
  if (p.samples < kLeast)
    throw CannotAnswer(record.file + ": " + std::to_string(record.samples()) + " samples, " +
                       std::to_string(p.samples) + " for its motion; a diagnosis needs at least " +
                       std::to_string(kLeast));
  p.smooth_half = std::clamp<Index>(static_cast<Index>(0.15 / (p.top_Hz * p.step_s)), 2, p.samples / 8);
  p.slow_half = std::clamp<Index>(static_cast<Index>(std::min(8 / p.top_Hz, slow_s(p)) / p.step_s), 8, p.samples / 3);
  p.base.ridden = rides_on_base(rig, p);
  tell_drift(p);
  renew_motion(p);
  return p;
}

// Without masses nothing is stepped through, and a low-pass would round the jumps of friction where the motion turns.
Thinning thinning_for(const rig_file::RigModel& rig, const host_sim::Record& record) {
  Thinning thinning = thinning_of(rig, record);
  if (massless(rig)) thinning.by = 1;
  return thinning;
}

}  // namespace

Prepared prepare(const rig_file::RigModel& rig, const host_sim::Record& record) {
  return thinned_out(rig, record, thinning_for(rig, record));
}

std::vector<Prepared> prepare_all(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                                  const std::vector<host_sim::Record>& holdout) {
  std::vector<const host_sim::Record*> records;
  for (const auto* list : {&training, &holdout})
    for (const host_sim::Record& r : *list) records.push_back(&r);
  std::vector<Thinning> thinnings;
  double step_s = 1e300;
  for (const host_sim::Record* r : records) {
    thinnings.push_back(thinning_for(rig, *r));
    step_s = std::min(step_s, r->sample_period_s * thinnings.back().by);
  }
  std::vector<Prepared> list;
  double begins_s = 0;
  for (size_t i = 0; i < records.size(); ++i) {
    thinnings[i].by = std::max(1, static_cast<int>(step_s / records[i]->sample_period_s + 1e-6));
    list.push_back(thinned_out(rig, *records[i], thinnings[i]));
    list[i].middle_s = begins_s + 0.5 * list[i].time_s(list[i].samples);
    begins_s += list[i].time_s(list[i].samples);
  }
  double mean_s = 0;
  for (const Prepared& p : list) mean_s += p.middle_s / static_cast<double>(list.size());
  for (Prepared& p : list) p.middle_s -= mean_s;
  return list;
}

}  // namespace diagnosis::runs
