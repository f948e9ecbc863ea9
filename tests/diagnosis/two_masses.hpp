// Two masses that a test moves by itself, and what a diagnosis said of them. Shares no code with the plant.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "host_sim/diagnosis/diagnosis.hpp"

namespace two_masses {

struct State {
  double x[2] = {0, 0}, v[2] = {0, 0};
};

inline State moved(const State& s, const State& slope, double h) {
  State out = s;
  for (int i = 0; i < 2; ++i) out.x[i] += h * slope.x[i], out.v[i] += h * slope.v[i];
  return out;
}

// Fourth-order Runge-Kutta over h. slope(state, drive); drive at the start, in the middle and at the end of the step.
template <typename Drive, typename Slope>
State stepped(const State& s, double h, const Drive& start, const Drive& middle, const Drive& end, Slope slope) {
  const State k1 = slope(s, start), k2 = slope(moved(s, k1, h / 2), middle), k3 = slope(moved(s, k2, h / 2), middle),
              k4 = slope(moved(s, k3, h), end);
  return moved(moved(moved(moved(s, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
}

// All that can be measured of one mass that a force drives.
inline host_sim::Record of_one_mass(const char* file, double rate_Hz, const std::vector<double>& force,
                                    const std::vector<double>& x, const std::vector<double>& v,
                                    const std::vector<double>& a) {
  host_sim::Record record;
  record.file = file, record.sample_period_s = 1 / rate_Hz;
  record.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, force},
                     {"displacement_1_m", host_sim::Quantity::kDisplacement, 1, x},
                     {"velocity_1_m_s", host_sim::Quantity::kVelocity, 1, v},
                     {"acceleration_1_m_s2", host_sim::Quantity::kAcceleration, 1, a}};
  return record;
}

// "explained, backlash on link 1-2"
inline std::string said(const diagnosis::Diagnosis& d) {
  std::string text = diagnosis::verdict_word(d.verdict);
  for (const diagnosis::Cause& c : d.causes) text += ", " + c.effect + " on " + c.where;
  return text;
}

// A number of a model; fails the test where it is not there.
inline diagnosis::Parameter parameter_of(const diagnosis::ModelScore& model, const std::string& name) {
  for (const diagnosis::Parameter& p : model.parameters)
    if (p.name == name) return p;
  ADD_FAILURE() << name << " is not there";
  return {};
}
inline double value_of(const diagnosis::ModelScore& model, const std::string& name) {
  return parameter_of(model, name).value;
}

}  // namespace two_masses
