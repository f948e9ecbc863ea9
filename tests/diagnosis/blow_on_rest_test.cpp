// A force that rises within one sample on a rig that sticks: each link lets go at its own instant.
#include <gtest/gtest.h>

#include "host_sim/diagnosis/simulate/simulator.hpp"

namespace {

using namespace diagnosis;
using namespace diagnosis::runs;

constexpr double kRise_N_s = 1e4;  // 100 N at the first sample, 0.01 s
constexpr double kStep_s = 0.01;

// Masses of 1 kg in a row, each link with a dry friction alone: 1 N at the ground, 0.5 N between. The force acts on the first.
struct Rig {
  System system;
  Model model;
  Prepared record;
  explicit Rig(int masses) {
    rig_file::RigModel rig;
    rig.dofs.resize(static_cast<size_t>(masses)), rig.links.resize(static_cast<size_t>(masses));
    for (int i = 0; i < masses; ++i)
      rig.links[static_cast<size_t>(i)].a = i + 1, rig.links[static_cast<size_t>(i)].b = i;
    system = make_system(rig);
    const auto add = [&](const Term& term, double value) {
      ModelTerm t;
      t.term = term, t.value = value;
      model.push_back(t);
    };
    for (int i = 0; i < masses; ++i) add(on_dof(Kind::kMass, i), 1), add(on_link(Kind::kCoulomb, i), i == 0 ? 1 : 0.5);
    constexpr Index kSamples = 12;
    record.step_s = record.read_every_s = kStep_s, record.samples = kSamples, record.period_s = 1, record.top_Hz = 2;
    record.force.resize(static_cast<size_t>(masses)), record.guess.resize(static_cast<size_t>(masses) + 1);
    record.force[0] = Vec::LinSpaced(kSamples, 0, kRise_N_s * kStep_s * static_cast<double>(kSamples - 1));
  }
  Vec after_one_sample() {
    Simulator s(system, model, record);
    Vec y = Vec::Zero(s.states());
    for (Index i = 0; i < s.nodes(); ++i) y[s.nodes() + i] = -1e-12 * static_cast<double>(i + 1);  // about to stop
    s.start(0, y);
    s.advance(0, y, nullptr);
    return y;
  }
};

// It is held until the force is 1 N, at 0.1 ms. From then on the mass gathers 10^4 t - 1:
// 10^4 (0.01^2 - 0.0001^2) / 2 - (0.01 - 0.0001) = 0.49005 m/s.
TEST(BlowOnRest, LetsGoAtTheInstantAtWhichFrictionIsExceeded) {
  EXPECT_NEAR(Rig(1).after_one_sample()[1], 0.49005, 2e-5);
}

// The first mass lets go of the ground at 0.1 ms and takes the second along with (10^4 t - 1) / 2, until that needs 0.5 N: at
// 0.2 ms, both at 10^4 0.0001^2 / 4 = 0.000025 m/s. From then on the second gathers 0.5 m/s^2, to 0.000025 + 0.0049 = 0.004925
// m/s, and the first 10^4 t - 1.5: 0.000025 + 10^4 (0.01^2 - 0.0002^2) / 2 - 1.5 * 0.0098 = 0.485125 m/s.
TEST(BlowOnRest, PassesThroughTheLinksInTheirTurn) {
  const Vec y = Rig(2).after_one_sample();
  EXPECT_NEAR(y[2], 0.485125, 2e-5);
  EXPECT_NEAR(y[3], 0.004925, 2e-5);
}

}  // namespace
