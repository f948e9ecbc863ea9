#include "prepared.hpp"

#include <algorithm>
#include <cmath>

#include "../record/motion.hpp"
#include "../record/riding.hpp"
#include "band.hpp"
#include "between_samples.hpp"
#include "guess.hpp"
#include "hal/rig_file/channel_entry.hpp"
#include "host_sim/records/value_step.hpp"
#include "windowed_force.hpp"

namespace diagnosis::runs {

bool massless(const rig_file::RigModel& rig) {
  return std::all_of(rig.dofs.begin(), rig.dofs.end(),
                     [](const rig_file::Dof& d) { return !d.mass_kg.estimate && d.mass_kg.value == 0; });
}

double white_noise_sum(const Vec& y) {
  const Index n = y.size() - 3;
  if (n < 1) return 0;
  return (y.tail(n) - 3 * y.segment(2, n) + 3 * y.segment(1, n) - y.head(n)).squaredNorm() / 20;
}

namespace {

constexpr double kSamplesPerTop = 24;  // of the fastest motion: one Runge-Kutta step each is right to 1e-4
// Of the motion of its ends, that of a link: where it is less, the part of their power that thinning may lose can be a hundredth of its own.
constexpr double kTogether = 0.1;
constexpr double kSlowPeriods =
    1;  // of the slowest that is kept: it loses nothing of it, and two thirds of what is half as fast
constexpr double kMostlySlow = 0.5;  // of the square of a velocity about its mean

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

struct Needs {
  int by = 1;
  double top_Hz = 0;
};

Vec values_of(const host_sim::Channel& c) { return Vec::Map(c.values.data(), static_cast<Index>(c.values.size())); }

// A delay that the rig file states is no fault to be found.
Vec in_time(const rig_file::RigModel& rig, const host_sim::Record& record, const host_sim::Channel& c) {
  const double late_s = rig_file::stated_delay_s(rig, c.name);
  return late_s == 0 ? values_of(c) : delayed(values_of(c), -late_s / record.sample_period_s);
}

// What moves a shaft is lost in the spectra of its ends where they turn together.
double top_of_link(const rig_file::Link& link, const host_sim::Record& record, host_sim::Quantity quantity) {
  const host_sim::Channel *a = record.find(quantity, link.a), *b = record.find(quantity, link.b);
  if (link.a < 1 || link.b < 1 || !a || !b) return 0;
  const Vec end = values_of(*a), between = end - values_of(*b);
  if (rms_about_mean(between) > kTogether * rms_about_mean(end)) return 0;
  return top_frequency(between, record.sample_period_s, quantity == host_sim::Quantity::kDisplacement);
}

Needs needs_of(const rig_file::RigModel& rig, const host_sim::Record& record) {
  Needs needs;
  for (const host_sim::Channel& c : record.channels) {
    if (c.quantity == host_sim::Quantity::kForce) continue;
    needs.top_Hz = std::max(needs.top_Hz, top_frequency(values_of(c), record.sample_period_s,
                                                        c.quantity == host_sim::Quantity::kDisplacement));
  }
  for (const rig_file::Link& link : rig.links)
    for (const auto quantity :
         {host_sim::Quantity::kDisplacement, host_sim::Quantity::kVelocity, host_sim::Quantity::kAcceleration})
      needs.top_Hz = std::max(needs.top_Hz, top_of_link(link, record, quantity));
  const double wanted = 1 / (record.sample_period_s * kSamplesPerTop * needs.top_Hz);
  const double most = static_cast<double>(record.samples()) / 4000;  // short work as it is
  needs.by = std::max(1, static_cast<int>(std::min(wanted, most)));
  return needs;
}

// Half of what the drift of integrated motion is averaged over, of the DOF that is slowest. What is slower is noise that integration raises:
// of a decay of one frequency it was the larger part of the displacement.
double slow_s(const Prepared& p) {
  double longest = 0;
  for (const MotionTrace& t : p.traces) {
    if (trace_of(p, t.dof, 0) || (t.quantity == 2 && trace_of(p, t.dof, 1))) continue;
    longest = std::max(longest, kSlowPeriods / slowest_above_noise(t.y, p.step_s, t.quantity));
  }
  return longest > 0 ? longest : 1e300;
}

// What an integral without its drift does not hold is slower than that: of a shaft that runs down all there is. Its period is that of a
// decay with the same slope.
double slow_period(const Vec& v, const Drift& drift, double step_s) {
  const Vec slow = v - without_drift(v, drift);
  const double about = rms_about_mean(slow), whole = rms_about_mean(v);
  if (!(about * about > kMostlySlow * whole * whole)) return 0;
  const Index n = slow.size();
  const double slope =
      std::sqrt((slow.tail(n - 1) - slow.head(n - 1)).squaredNorm() / static_cast<double>(n - 1)) / step_s;
  return slope > 0 ? kTwoPi * about / slope : 0;
}

double period_of(const Prepared& p) {
  double longest = 0;
  for (size_t i = 0; i < p.guess.size(); ++i) {
    const Guess& g = p.guess[i];
    if (!g.given) continue;
    const int dof = static_cast<int>(i);
    const MotionTrace* place = trace_of(p, dof, 0);
    const double v = rms_about_mean(g.v);
    const double x = place && place->travels ? std::sqrt(square_off_line(g.x) / static_cast<double>(g.x.size()))
                                             : rms_about_mean(g.x);
    if (v > 0) longest = std::max(longest, kTwoPi * x / v);
    if (!place && trace_of(p, dof, 1)) longest = std::max(longest, slow_period(g.v, {p.slow_half}, p.step_s));
  }
  return longest;
}

constexpr size_t kLevels = 5;  // of what a relay or a step switches between

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

Prepared prepare_by(const rig_file::RigModel& rig, const host_sim::Record& record, const Needs& needs) {
  Prepared p;
  p.file = record.file;
  p.step_s = record.sample_period_s * needs.by;
  p.read_every_s = record.sample_period_s;
  p.top_Hz = needs.top_Hz;
  const auto series = [&](const host_sim::Channel& c) { return thinned(in_time(rig, record, c), needs.by); };
  const int n = static_cast<int>(rig.dofs.size());
  p.force.resize(static_cast<size_t>(n)), p.noise_in_blows.resize(static_cast<size_t>(n));
  for (const host_sim::Channel& c : record.channels) {
    if (c.quantity == host_sim::Quantity::kForce && c.dof >= 1 && c.dof <= n) {
      const Vec raw = in_time(rig, record, c);
      const Windowed f = massless(rig) ? Windowed{raw, {}, {}} : windowed(raw);
      const size_t d = static_cast<size_t>(c.dof - 1);
      p.force[d] = thinned(f.force, needs.by);
      // as it was recorded: interpolation rounds the edges of a command
      p.noise_in_blows[d] = switches(values_of(c)) ? Vec::Zero(p.force[d].size()) : noise_in_blows(f, needs.by);
      continue;
    }
    const int quantity = c.quantity == host_sim::Quantity::kDisplacement ? 0
                         : c.quantity == host_sim::Quantity::kVelocity   ? 1
                                                                         : 2;
    if (c.dof == rig_file::kBase)
      p.base.reading[static_cast<size_t>(quantity)] = series(c);
    else if (c.dof >= 1 && c.dof <= n)
      p.traces.push_back({c.dof - 1, quantity, c.name, series(c), host_sim::value_step(c)});
  }
  for (const MotionTrace& t : p.traces) p.samples = t.y.size();
  for (MotionTrace& t : p.traces) t.travels = t.quantity == 0 && travels(t.y);
  // Where nothing drives the motion its middle is free anyway: runs start from it, wherever the sensor has its zero.
  if (!driven(p))
    for (MotionTrace& t : p.traces)
      if (t.quantity == 0) t.y.array() -= middle(t.y);
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

}  // namespace

const MotionTrace* trace_of(const Prepared& p, int dof, int quantity) {
  for (const MotionTrace& t : p.traces)
    if (t.dof == dof && t.quantity == quantity) return &t;
  return nullptr;
}

double motion_square(const Prepared& p, const MotionTrace& trace, Index from, Index length) {
  const auto y = trace.y.segment(from, length);
  if (!trace.travels) return (y.array() - y.mean()).square().sum();
  const double of_speed =
      rms_about_mean(p.guess[static_cast<size_t>(trace.dof)].v) * static_cast<double>(length) * p.step_s / kTwoPi;
  return std::max(square_off_line(y), static_cast<double>(length) * of_speed * of_speed);
}

void renew_motion(Prepared& p) {
  p.guess.clear();
  for (size_t d = 0; d < p.force.size(); ++d) {
    std::vector<const Vec*> measured(3, nullptr);
    for (const MotionTrace& t : p.traces)
      if (t.dof == static_cast<int>(d)) measured[static_cast<size_t>(t.quantity)] = &t.y;
    if (!measured[0] && !measured[1] && !measured[2])
      throw CannotAnswer(p.file + ": no displacement, velocity or acceleration of DOF " + std::to_string(d + 1) +
                         "; measure one of them");
    Vec against_base;
    if (p.base.ridden) against_base = *measured[2] - p.base.reading[2], measured[2] = &against_base;
    p.guess.push_back(guess_of(measured, p.step_s, p.smooth_half, {p.slow_half}));
    if (p.base.ridden) p.guess.back().a += p.base.reading[2];
  }
  p.guess.push_back({});
  renew_base(p);
  p.period_s = period_of(p);
}

Prepared prepare(const rig_file::RigModel& rig, const host_sim::Record& record) {
  return prepare_by(rig, record, needs_of(rig, record));
}

std::vector<Prepared> prepare_all(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                                  const std::vector<host_sim::Record>& holdout) {
  std::vector<const host_sim::Record*> records;
  for (const auto* list : {&training, &holdout})
    for (const host_sim::Record& r : *list) records.push_back(&r);
  std::vector<Needs> needs;
  double step_s = 1e300;
  for (const host_sim::Record* r : records) {
    needs.push_back(needs_of(rig, *r));
    step_s = std::min(step_s, r->sample_period_s * needs.back().by);
  }
  std::vector<Prepared> list;
  double begins_s = 0;
  for (size_t i = 0; i < records.size(); ++i) {
    needs[i].by = std::max(1, static_cast<int>(step_s / records[i]->sample_period_s + 1e-6));
    list.push_back(prepare_by(rig, *records[i], needs[i]));
    list[i].middle_s = begins_s + 0.5 * list[i].time_s(list[i].samples);
    begins_s += list[i].time_s(list[i].samples);
  }
  double mean_s = 0;
  for (const Prepared& p : list) mean_s += p.middle_s / static_cast<double>(list.size());
  for (Prepared& p : list) p.middle_s -= mean_s;
  return list;
}

double noise_level(const Vec& f) {
  if (f.size() == 0 || f.cwiseAbs().maxCoeff() == 0) return 0;
  const size_t n = fast_length(static_cast<size_t>(f.size()));
  const Vec power = Fourier(n).forward(tapered(f.head(static_cast<Index>(n)))).cwiseAbs2() / static_cast<double>(n);
  std::vector<double> top(power.data() + power.size() * 2 / 3, power.data() + power.size() * 4 / 5);
  std::nth_element(top.begin(), top.begin() + static_cast<std::ptrdiff_t>(top.size() / 2), top.end());
  return std::sqrt(top[top.size() / 2] / kMedianOfSpread);
}

Vec noise_along_force(const Prepared& p, size_t dof) {
  if (dof < p.noise_in_blows.size() && p.noise_in_blows[dof].size()) return p.noise_in_blows[dof];
  return Vec::Constant(p.force[dof].size(), noise_level(p.force[dof]));
}

double noise_of_force(const Prepared& p, size_t dof) {
  return p.force[dof].size() ? noise_along_force(p, dof).maxCoeff() : 0;
}

}  // namespace diagnosis::runs
