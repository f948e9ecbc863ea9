// A base that drives a rig: its displacement from a slower reading's integral, and its noise in the rows.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/diagnosis/motion/prepared.hpp"
#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis::runs;

constexpr double kTwoPi = 6.283185307179586, kStep_s = 1e-3;
constexpr int kSamples = 20000;
constexpr double kHertz[] = {0.7, 3, 31};         // 20 s hold 14 periods of the slowest
constexpr double kRate_m_s[] = {0.02, 0.1, 0.1};  // amplitudes of velocity

// What the base moves by: sum of v / w sin(w t); times: of its derivatives.
double moved(int times, double t) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double w = kTwoPi * kHertz[i];
    sum += kRate_m_s[i] * std::pow(w, times - 1) * std::sin(w * t + times * kTwoPi / 4);
  }
  return sum;
}

// A mass between the base and the ground (against the base alone accelerations would do), read as the base is: with a hundredth of
// noise and a zero of a twentieth.
Prepared prepared(int quantity) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(2);
  rig.dofs[0].mass_kg.value = 1;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kBase, rig.links[0].stiffness_N_m.value = 4000;
  rig.links[1].a = 1, rig.links[1].b = rig_file::kGround, rig.links[1].stiffness_N_m.value = 4000;
  host_sim::Record record;
  record.file = "base.csv", record.sample_period_s = kStep_s;
  std::mt19937_64 random(3);
  const double rms = quantity == 1 ? 0.1 : 14;  // of 0.1 m/s at 31 Hz: 19.5 m/s^2 of amplitude
  std::normal_distribution<double> noise(0.05 * rms, 0.01 * rms);
  const std::string name = quantity == 1 ? "velocity_" : "acceleration_", unit = quantity == 1 ? "_m_s" : "_m_s2";
  for (const int dof : {rig_file::kBase, 1}) {
    host_sim::Channel c;
    c.name = name + (dof == 1 ? "1" : "base") + unit, c.dof = dof;
    c.quantity = quantity == 1 ? host_sim::Quantity::kVelocity : host_sim::Quantity::kAcceleration;
    for (int k = 0; k < kSamples; ++k) c.values.push_back(moved(quantity, k * kStep_s) + noise(random));
    record.channels.push_back(c);
  }
  return prepare(rig, record);
}

// Amplitude at a frequency over whole periods in the middle of a record, beside what slow drift leaves: of the sine part and of the
// cosine part.
double amplitude(const Vec& y, double step_s, double hertz) {
  const auto period = static_cast<Index>(std::lround(10 / step_s));  // 7, 30 and 310 periods
  const Index from = (y.size() - period) / 2;
  double sine = 0, cosine = 0, weight = 0;
  for (Index k = 0; k < period; ++k) {
    const double t = static_cast<double>(from + k) * step_s,
                 taper = 1 - std::cos(kTwoPi * static_cast<double>(k) / static_cast<double>(period));
    sine += taper * y[from + k] * std::sin(kTwoPi * hertz * t),
        cosine += taper * y[from + k] * std::cos(kTwoPi * hertz * t);
    weight += taper;
  }
  return 2 * std::hypot(sine, cosine) / weight;
}

// Velocity's noise, 1 mm/s a sample, makes 1e-3 sqrt(2 * 1e-3 / 10) / w of an amplitude over 10 s: 0.3 um of 4.5 mm at 0.7 Hz.
TEST(BaseReading, AVelocityTellsTheDisplacementOfAllItsFrequencies) {
  const Prepared p = prepared(1);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(amplitude(p.guess.back().x, p.step_s, kHertz[i]), kRate_m_s[i] / (kTwoPi * kHertz[i]),
                0.003 * kRate_m_s[i] / (kTwoPi * kHertz[i]))
        << kHertz[i] << " Hz";
}

// An acceleration's noise of 0.14 m/s^2 integrated twice: 0.14 sqrt(2e-4) / w^2, 0.1 mm of 4.5 at 0.7 Hz.
TEST(BaseReading, AnAccelerationTellsItToo) {
  const Prepared p = prepared(2);
  const double within[] = {0.05, 0.005, 0.005};
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(amplitude(p.guess.back().x, p.step_s, kHertz[i]), kRate_m_s[i] / (kTwoPi * kHertz[i]),
                within[i] * kRate_m_s[i] / (kTwoPi * kHertz[i]))
        << kHertz[i] << " Hz";
}

// Rigs that their files describe, driven by their base; a hundredth of noise in every channel.
struct Told {
  hidden_rig::Draw draw;
  diagnosis::Diagnosis d;
  Told(uint64_t seed, const char* sensors) {
    hidden_rig::Settings settings;
    settings.condition = "moving_base", settings.sensors = sensors;
    draw = hidden_rig::make_draw(seed, settings);
    d = diagnosis::diagnose(draw.rig, draw.records, {});
  }
};

// The base's noise shakes every spring that stands on it: no tone, and no stiffness that changes with time.
TEST(BaseReading, NoiseOfTheBaseIsNoTrace) {
  for (uint64_t seed = 15700001; seed < 15700009; ++seed)
    for (const char* sensors : {"xva", "xa"})
      EXPECT_EQ(two_masses::said(Told(seed, sensors).d), "none") << seed << sensors;
}

TEST(BaseReading, AVelocityAloneGivesTheDampers) {
  int viscous = 0, held = 0;
  for (uint64_t seed = 15700001; seed < 15700009; ++seed) {
    const Told told(seed, "v");
    EXPECT_EQ(two_masses::said(told.d), "none") << seed;
    for (const hidden_rig::TrueCoefficient& truth : told.draw.coefficients)
      for (const diagnosis::Parameter& p : told.d.baseline.parameters)
        if (p.name == truth.name && p.name.rfind("viscous", 0) == 0) {
          ++viscous, held += std::abs(p.value - truth.value) < 2 * p.std;
          EXPECT_NEAR(p.value, truth.value, 4 * p.std) << seed << " " << p.name;
          EXPECT_LT(p.std, 0.03 * truth.value) << seed << " " << p.name;
        }
  }
  EXPECT_GE(viscous, 12);
  EXPECT_GE(held, viscous * 4 / 5);
}

}  // namespace
