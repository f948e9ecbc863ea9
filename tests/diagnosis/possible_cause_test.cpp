// Causes that a decay shows while it is loud, or beside something larger that nobody knows.
#include <algorithm>
#include <cmath>
#include <random>

#include "host_sim/diagnosis/numbers/parameter_status.hpp"
#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

constexpr double kTwoPi = 6.283185307179586;

bool told(const diagnosis::Diagnosis& d, const diagnosis::NamedPlace& place) {
  return d.names(place.effect, place.where) ||
         std::find(d.ambiguous_with.begin(), d.ambiguous_with.end(), place) != d.ambiguous_with.end();
}

// Accelerations with noise of their own beside displacements that show all: noise is most of what is left of the former in the quiet
// windows at a decay's end, and little of the latter. A resonance that takes five sixths of the error was not named.
TEST(PossibleCause, NoiseOfOneChannelIsNotThatOfAnother) {
  hidden_rig::Settings settings;
  settings.condition = "free_decay_to_rest", settings.sensors = "xva", settings.hidden = "unmodelled_resonance";
  const hidden_rig::Draw draw = hidden_rig::make_draw(33400007, settings);
  ASSERT_EQ(draw.hidden[0].where, "dof 1");
  const diagnosis::Diagnosis d = diagnosis::diagnose(draw.rig, draw.records, {});
  EXPECT_TRUE(told(d, {"unmodelled_resonance", "dof 1"})) << two_masses::said(d);
}

using Force = double (*)(double t, double x, double v);

// One DOF let go, by steps of a 20th of a sample. Friction takes what speed it can in a step.
host_sim::Record decay(double mass, double coulomb, double start, double rate_Hz, double duration_s, double noise,
                       Force force, host_sim::Quantity quantity) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  host_sim::Record record;
  record.file = "decay.csv", record.sample_period_s = 1 / rate_Hz;
  record.channels = {{"", quantity, 1, {}}};
  constexpr int kFiner = 20;
  const double h = 1 / (rate_Hz * kFiner);
  double x = start, v = 0;
  for (int k = 0; k < static_cast<int>(rate_Hz * duration_s); ++k) {
    const double t = k / rate_Hz, a = force(t, x, v) / mass;
    record.channels[0].values.push_back((quantity == host_sim::Quantity::kDisplacement ? x : a) +
                                        noise * normal(random));
    for (int i = 0; i < kFiner; ++i) {
      x += 0.5 * h * v;
      v += h * force(t + (i + 0.5) * h, x, v) / mass;
      v = std::copysign(std::max(0.0, std::abs(v) - h * coulomb / mass), v);
      x += 0.5 * h * v;
    }
  }
  return record;
}

rig_file::RigModel one_wheel(double stiffness) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.dofs[0].mass_kg.estimate = rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  rig.links[0].stiffness_N_m.value = stiffness;
  return rig;
}

// A wheel on a spiral spring that softens, read ten times a second: 2.4 rad at first and a hundredth of that where the decay is not
// fitted. The cubic spring takes nearly all of the error there is, and the quiet end cannot show it.
TEST(PossibleCause, IsNamedThoughTheQuietEndCannotShowIt) {
  const host_sim::Record record = [] {
    host_sim::Record r = decay(
        1.9e-3, 2e-5, 2.4, 10, 60, 2e-3,
        [](double, double x, double v) { return -0.02 * x + 1e-4 * x * x * x - 2.5e-4 * v; },
        host_sim::Quantity::kDisplacement);
    r.channels[0].name = "displacement_1_m";
    return r;
  }();
  const diagnosis::Diagnosis d = diagnosis::diagnose(one_wheel(0.02), {record}, {});
  EXPECT_TRUE(told(d, {"cubic_stiffness", "link 1-0"})) << two_masses::said(d);
  for (const diagnosis::Cause& c : d.causes)
    EXPECT_NE(c.effect, "sensor_gain");  // of the only channel, and nothing drives
  for (const diagnosis::NamedPlace& p : d.ambiguous_with) EXPECT_NE(p.effect, "sensor_gain");
}

// Drag beside a damper, 0.02 N s^2/m^2 beside 0.03 N s/m, and a spring whose stiffness wanders by two thousandths: that is most of
// what is left, and nothing in the vocabulary. The drag takes a small part of it and is not sure, but the damper would be
// two thirds of what it seems.
TEST(PossibleCause, TakesTheWarrantFromWhatItWouldBend) {
  host_sim::Record record = decay(
      1, 0, 0.08, 250, 80, 2e-3,
      [](double t, double x, double v) {
        return -716 * (1 + 2e-3 * std::sin(kTwoPi * t / 23) * std::sin(kTwoPi * t / 41)) * x - 0.03 * v -
               0.02 * v * std::abs(v);
      },
      host_sim::Quantity::kAcceleration);
  record.channels[0].name = "acceleration_1_m_s2";
  rig_file::RigModel rig = one_wheel(0);
  rig.dofs[0].mass_kg = {1, false}, rig.links[0].stiffness_N_m.estimate = true, rig.links[0].coulomb_N.estimate = false;
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig, {record}, {});
  ASSERT_TRUE(d.causes.empty()) << two_masses::said(d);
  ASSERT_FALSE(d.possible.empty());
  const diagnosis::Parameter viscous = two_masses::parameter_of(d.baseline, "viscous[1-0]");
  EXPECT_GT(viscous.value, 0.045);
  EXPECT_TRUE(viscous.may_be_bent);
  EXPECT_STREQ(diagnosis::status_word(viscous, true), "BIAS_SUSPECT");
  bool drag = false;
  for (const diagnosis::PossibleCause& c : d.possible)
    for (const diagnosis::Parameter& p : c.bends)
      if (c.place.effect == "quadratic_damping" && p.name == "viscous[1-0]") {
        drag = true;
        EXPECT_NEAR(p.value, 0.03, 0.006);
      }
  EXPECT_TRUE(drag);
}

}  // namespace
