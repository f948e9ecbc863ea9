// Made-up report data: signals of known shape, enough of them to fill every part of both pages.
#pragma once
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/reports/data/run_report_data.hpp"

namespace made_up {

using namespace host_sim::reports;

inline std::vector<double> sines(size_t samples, double period_s, double scale, double phase, double detune) {
  std::vector<double> out(samples);
  for (size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) * period_s;
    const double swell = 0.6 + 0.4 * std::sin(0.9 * t + phase);
    out[i] = scale * swell *
             (std::sin(2 * M_PI * 7.3 * detune * t + phase) + 0.5 * std::sin(2 * M_PI * 16.1 * t + 2 * phase) +
              0.2 * std::sin(2 * M_PI * 29.7 * detune * t));
  }
  return out;
}

inline std::vector<double> noisy(std::vector<double> values, double std, unsigned seed) {
  std::mt19937 random(seed);
  for (double& value : values) value += std * (static_cast<double>(random()) / 2147483648.0 - 1.0);
  return values;
}

inline DiagnosisReportData diagnosis(size_t samples = 20000) {
  const double period_s = 1e-3;
  DiagnosisReportData data;
  data.rig_name = "three masses & a <friction> link";
  data.files = {"record_1.csv", "record_2.csv"};
  data.facts = {"20 s at 1000 Hz", "noise of displacement 1: 0.9 % of rms"};
  data.verdict = "explained";
  data.causes = {
      {"cubic_stiffness", "link 1-2", 97.3, {"cubic_stiffness[1-2] = 3.12e7 N/m^3 (95 %: 3.08e7 to 3.16e7)"}},
      {"sensor_delay", "channel displacement_2_m", 2.1, {"delay = 251 us (95 %: 247 to 255)"}}};
  for (int dof = 1; dof <= 3; ++dof) {
    DofView view;
    view.dof = dof;
    view.period_s = period_s;
    const double phase = dof;
    const auto clean = sines(samples, period_s, 2e-3 / dof, phase, 1.0);
    view.waveforms.push_back({"displacement", "m", noisy(clean, 2e-5, 1u + static_cast<unsigned>(dof)),
                              sines(samples, period_s, 2e-3 / dof, phase, 1.004), clean, ""});
    const auto push = sines(samples, period_s, 90.0, phase, 1.0);
    view.waveforms.push_back(
        {"acceleration", "m/s^2", noisy(push, 2.0, 7u), sines(samples, period_s, 90.0, phase, 1.004), push, "derived"});
    std::vector<double> drive(samples), viscous(samples), coulomb(samples), stored(samples), left(samples),
        after(samples);
    for (size_t i = 0; i < samples; ++i) {
      const double t = static_cast<double>(i) * period_s;
      view.energy.time_s.push_back(t);
      drive[i] = 3.0 * t + 0.3 * std::sin(8 * t);
      viscous[i] = -2.2 * t;
      coulomb[i] = -0.5 * t;
      stored[i] = -0.25 * std::sin(8 * t);
      left[i] = drive[i] + viscous[i] + coulomb[i] + stored[i];
      after[i] = 0.02 * left[i];
    }
    view.energy.terms = {
        {"drive force", drive}, {"viscous[1-0]", viscous}, {"coulomb[3-0]", coulomb}, {"stored", stored}};
    view.energy.residual = left;
    view.energy.residual_extended = after;
    data.dofs.push_back(view);
    data.gains.push_back({dof, 12.5 / dof, 1.1, 31.0, 0.4});
  }
  for (const char* name : {"1-0", "1-2"}) {
    LinkView link;
    link.link = name;
    link.elongation = sines(samples, period_s, 2e-3, 0.4, 1.0);
    link.rate = sines(samples, period_s, 0.12, 1.9, 1.0);
    std::vector<double> force(samples);
    for (size_t i = 0; i < samples; ++i) {
      link.time_s.push_back(static_cast<double>(i) * period_s);
      force[i] = name[2] == '2' ? 3.1e8 * std::pow(link.elongation[i], 3) : 0.0;
    }
    link.residual = noisy(force, 0.4, 3u);
    link.residual_extended = noisy(std::vector<double>(samples, 0.0), 0.4, 4u);
    if (name[2] == '2') {
      link.named_effect = "cubic_stiffness";
      link.named_force = force;
    }
    data.links.push_back(link);
  }
  data.score_name = "chi² gain";
  data.candidates = {{"cubic_stiffness", "link 1-2", 14724, 35, true, ""},
                     {"sensor_delay", "channel displacement_2_m", 612, 30, true, ""},
                     {"end_stop", "link 1-2", 9822, 35, false, "less than cubic stiffness, and nothing on top of it"},
                     {"quadratic_damping", "link 3-0", 12.2, 35, false, "below the threshold"}};
  data.parameters = {{"viscous[1-0]", "N s/m", {19.2, 18.8, 19.6}, {20.03, 19.95, 20.11}, "VALID"},
                     {"viscous[1-2]", "N s/m", {24.0, 22.0, 26.0}, {19.98, 19.81, 20.15}, "VALID"},
                     {"coulomb[3-0]", "N", {1.31, 1.1, 1.5}, {1.004, 0.991, 1.017}, "BIAS_SUSPECT"},
                     {"cubic_stiffness[1-2]", "N/m^3", {NAN, NAN, NAN}, {3.12e7, 3.08e7, 3.16e7}, "VALID"}};
  data.minimum_detectable = {{"cubic_stiffness", "link 1-2", "N/m^3", 4.1e5}, {"mass_error", "dof 2", "kg", 0.0021}};
  data.advice = {"Raise the level by half to tell a hardening spring from an end stop.",
                 "Add a second frequency near 16 Hz: viscous[1-2] and viscous[2-3] move together at the present one."};
  return data;
}

inline RunReportData run(size_t samples = 10000) {
  const double period_s = 1e-3;
  RunReportData data;
  data.scenario = "paper_3dof_random_noise";
  data.facts = {"seed 1", "1000 samples a second", "5 % noise on every channel"};
  data.condition_number = 12.4;
  data.residual_mean_abs = 1.3e-3;
  const char* const names[] = {"viscous[1-0]", "viscous[1-2]", "viscous[2-3]", "viscous[3-0]", "coulomb[3-0]"};
  for (int p = 0; p < 5; ++p) {
    const double truth = p < 4 ? 20.0 : 1.0;
    RunParameter parameter{
        names[p], p < 4 ? "N s/m" : "N", "VALID", truth, {truth * 1.002, truth * 0.995, truth * 1.009}, {}};
    for (int window = 1; window <= 100; ++window) {
      const double spread = truth * 0.08 / std::sqrt(window);
      const double value = truth + spread * 0.7 * std::sin(0.4 * window + p);
      parameter.convergence.time_s.push_back(0.2 * window);
      parameter.convergence.value.push_back(value);
      parameter.convergence.low.push_back(value - spread);
      parameter.convergence.high.push_back(value + spread);
    }
    data.parameters.push_back(parameter);
  }
  for (int level = 1; level <= 2; ++level) {
    RunRecord record;
    record.label = level == 1 ? "rms 10 N, 5 to 50 Hz" : "rms 40 N, 5 to 50 Hz";
    record.period_s = period_s;
    const auto force = sines(samples, period_s, 14.0 * level, 0.3, 1.0);
    record.channels.push_back({"force 1", "N", force, noisy(force, 1.2 * level, 5u)});
    for (int dof = 1; dof <= 3; ++dof) {
      const auto x = sines(samples, period_s, 2e-3 * level / dof, dof, 1.0);
      record.channels.push_back({"displacement " + std::to_string(dof), "m", x, noisy(x, 2e-4 * level / dof, 9u)});
      const auto a = sines(samples, period_s, 50.0 * level, dof, 1.0);
      record.accelerations.push_back({dof, "m/s^2", 0.029, a, noisy(a, 0.4, 4u)});
    }
    data.records.push_back(record);
  }
  return data;
}

}  // namespace made_up
