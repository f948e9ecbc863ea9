#include "force_hum.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "../doubts/trifles.hpp"
#include "../record/fourier.hpp"
#include "../residual/lines.hpp"
#include "../terms/naming.hpp"
#include "../trial/paired.hpp"
#include "../trial/settle.hpp"
#include "host_sim/records/median.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kFineness_Hz = 0.01;  // of the mains' frequency about its nominal one

struct Wave {
  double hertz = 0, cosine = 0, sine = 0;
  double amplitude() const { return std::hypot(cosine, sine); }
};

// The wave near a nominal frequency that takes most of a force's square.
Wave wave_near(const Vec& force, double step_s, double nominal_Hz) {
  Wave best;
  double most = 0;
  for (double hertz = nominal_Hz - kMainsWidth_Hz; hertz <= nominal_Hz + kMainsWidth_Hz; hertz += kFineness_Hz) {
    Mat c(force.size(), 2);
    for (Index k = 0; k < force.size(); ++k) {
      const double angle = kTwoPi * hertz * static_cast<double>(k) * step_s;
      c(k, 0) = std::cos(angle), c(k, 1) = std::sin(angle);
    }
    const Vec right = c.transpose() * force;
    const Vec value = (c.transpose() * c).ldlt().solve(right);
    if (value.dot(right) > most) most = value.dot(right), best = {hertz, value[0], value[1]};
  }
  return best;
}

void take_out(const Wave& wave, double step_s, Vec& force) {
  for (Index k = 0; k < force.size(); ++k) {
    const double angle = kTwoPi * wave.hertz * static_cast<double>(k) * step_s;
    force[k] -= wave.cosine * std::cos(angle) + wave.sine * std::sin(angle);
  }
}

// How far a line near a nominal frequency stands above a force's level around; 0 where another bin there comes near it: the edge
// of a drive's band, or a drive that is loud there anyway.
double line_near(const Vec& force, double step_s, double nominal_Hz) {
  constexpr Index kLeakage = 3;  // bins on either side
  const size_t n = fast_length(static_cast<size_t>(force.size()));
  const Vec power = Fourier(n).forward(force.head(static_cast<Index>(n))).cwiseAbs2();
  const double bin_Hz = 1 / (static_cast<double>(n) * step_s);
  const Index from = static_cast<Index>((nominal_Hz - kMainsWidth_Hz) / bin_Hz),
              to = static_cast<Index>((nominal_Hz + kMainsWidth_Hz) / bin_Hz) + 1;
  if (from < kAround || to + kAround >= power.size()) return 0;
  Index peak = from;
  for (Index i = from; i <= to; ++i)
    if (power[i] > power[peak]) peak = i;
  std::vector<double> around;
  for (Index i = from - kAround; i <= to + kAround; ++i)
    if (std::abs(i - peak) > kLeakage) around.push_back(power[i]);
  if (kAlone * *std::max_element(around.begin(), around.end()) > power[peak]) return 0;
  return power[peak] * kMedianOfSpread / std::max(1e-300, host_sim::median(around));
}

// The largest hum of a motion channel beside a model, over its signal.
double hum_of_motion(const Task& task, const State& state) {
  const Left left = left_by(task.system, task.records, state);
  double worst = 0;
  for (size_t i = 0; i < left.hum.size() && i < task.records[0].traces.size(); ++i) {
    const double rms = rms_about_mean(task.records[0].traces[i].y);
    if (rms > 0) worst = std::max(worst, left.hum[i].amplitude / rms);
  }
  return worst;
}

// The strongest wave of a force's records that the motion does not answer to; of no amplitude where it does.
Wave borne_out_by_motion(const Task& task, const State& fitted, size_t dof, double nominal_Hz) {
  std::vector<Prepared> without = task.records;
  double share = 0;
  Wave strongest;
  for (Prepared& p : without) {
    if (p.force[dof].size() == 0) continue;
    const Wave wave = wave_near(p.force[dof], p.step_s, nominal_Hz);
    if (wave.amplitude() > strongest.amplitude()) strongest = wave;
    share = std::max(share, wave.amplitude() / std::max(1e-300, rms_about_mean(p.force[dof])));
    take_out(wave, p.step_s, p.force[dof]);
  }
  const Task cleaned{task.system, without, task.training};
  State clean = fitted;
  settle(cleaned, clean, kTrialSteps);
  if (!clean.fit.ok || share < kTrifle) return {};
  // A line that the simulation leaves in a motion channel and that goes with the force's own is no chance.
  const double before = hum_of_motion(task, fitted), after = hum_of_motion(cleaned, clean);
  const double least_z = before > kOneOfThem * after ? kSure : kNamed;
  const bool named = paired_z(fitted.fit, clean.fit) > least_z && share > kOneOfThem * after;
  return named ? strongest : Wave{};
}

}  // namespace

double wave_at_mains(const Vec& reading, double step_s, double nominal_Hz) {
  return reading.size() ? wave_near(reading, step_s, nominal_Hz).amplitude() : 0;
}

void name_force_hum(const Task& task, const State& fitted, Diagnosis& d) {
  if (!fitted.fit.ok || massless(fitted.model)) return;
  for (size_t dof = 0; dof < task.system.dofs(); ++dof)
    for (const double nominal_Hz : {50.0, 60.0}) {
      double over = 0;
      for (const Prepared& p : task.records)
        if (p.force[dof].size()) over = std::max(over, line_near(p.force[dof], p.step_s, nominal_Hz));
      const std::string channel = force_channel(task.system.rig, dof);
      if (over < kLine || d.names("mains_hum", "channel " + channel)) continue;
      const Wave hum = borne_out_by_motion(task, fitted, dof, nominal_Hz);
      if (hum.amplitude() == 0) continue;
      Cause c;
      c.effect = "mains_hum", c.where = "channel " + channel, c.significance = over, c.taken_out = true;
      const char* unit = task.system.rig.dofs[dof].rotating ? "N m" : "N";
      c.parameters.push_back({"mains_hum[" + channel + "]", hum.amplitude(), unit, 0, true});
      c.parameters.push_back({"mains_frequency[" + channel + "]", hum.hertz, "Hz", 0, false});
      d.causes.push_back(c);
      if (d.verdict == Verdict::kNone) d.verdict = Verdict::kExplained;
    }
}

}  // namespace diagnosis::runs
