// A base that moves: what sticks to it, and how it is read.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/diagnosis/first_values/start.hpp"
#include "host_sim/diagnosis/motion/fused.hpp"
#include "host_sim/diagnosis/simulate/simulator.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kStep_s = 1e-3, kOmega = 12;
constexpr int kSamples = 4000;

// x = X sin(w t), v = X w cos(w t), a = -X w^2 sin(w t)
double moved(int quantity, double amplitude, double t) {
  return quantity == 0   ? amplitude * std::sin(kOmega * t)
         : quantity == 1 ? amplitude * kOmega * std::cos(kOmega * t)
                         : -amplitude * kOmega * kOmega * std::sin(kOmega * t);
}

// A mass that only friction ties to the base. The rig of the model, and a record in which the mass rides on it.
struct Sled {
  rig_file::RigModel rig;
  host_sim::Record record;
  Sled(double mass, double friction, double amplitude) {
    rig.dofs.resize(1), rig.dofs[0].mass_kg.value = mass;
    rig.links.resize(1), rig.links[0].a = 1, rig.links[0].b = rig_file::kBase, rig.links[0].coulomb_N.value = friction;
    record.sample_period_s = kStep_s;
    const host_sim::Quantity quantities[] = {host_sim::Quantity::kDisplacement, host_sim::Quantity::kVelocity,
                                             host_sim::Quantity::kAcceleration};
    const char* names[] = {"displacement_base_m", "velocity_base_m_s", "acceleration_base_m_s2"};
    std::vector<double> values(kSamples);
    for (int q = 0; q < 3; ++q) {
      for (int k = 0; k < kSamples; ++k) values[static_cast<size_t>(k)] = moved(q, amplitude, k * kStep_s);
      record.channels.push_back({names[q], quantities[q], rig_file::kBase, values});
      if (q == 0) record.channels.push_back({"displacement_1_m", quantities[0], 1, values});
    }
  }
  // Largest acceleration of the mass after the start, and how far it ends from the base.
  void run(double& most, double& apart) const {
    const System system = make_system(rig);
    const std::vector<Prepared> records = prepare_all(rig, {record}, {});
    const Model model = rig_as_given(system, records);
    Simulator simulator(system, model, records[0]);
    Vec y = simulator.guessed_state(0), a;
    simulator.start(0, y);
    most = apart = 0;
    for (Index k = 0; k + 1 < records[0].samples; ++k) {
      ASSERT_TRUE(simulator.advance(k, y, nullptr));
      simulator.accelerations(k + 1, y, a, nullptr);
      most = std::max(most, std::abs(a[0])), apart = std::max(apart, std::abs(y[0] - records[0].guess.back().x[k + 1]));
    }
  }
};

// 2 kg on a base of amplitude 20 mm: it accelerates by 0.02 * 144 = 2.88 m/s^2, which takes 5.76 N.
TEST(MovingBase, FrictionThatIsStrongEnoughCarriesTheMass) {
  double most = 0, apart = 0;
  Sled(2, 6, 0.02).run(most, apart);
  EXPECT_NEAR(most, 2.88, 0.01);
  EXPECT_LT(apart, 2e-5);
}

// Friction of 4 N gives it 2 m/s^2 and no more: it slides.
TEST(MovingBase, FrictionThatIsTooWeakLetsItSlide) {
  double most = 0, apart = 0;
  Sled(2, 4, 0.02).run(most, apart);
  EXPECT_NEAR(most, 2, 0.01);
  EXPECT_GT(apart, 1e-3);
}

// Displacement with noise of 0.1 mm, acceleration with 0.03 m/s^2 and a zero of 0.5 m/s^2. Two neighbouring displacements tell the
// velocity to 140 mm/s, a cubic over 31 of them to some 3; integrating the noise of the acceleration over a second adds 1 mm/s.
TEST(MovingBase, AnAccelerometerTellsTheVelocityThatADisplacementAnchors) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  Vec x(kSamples), a(kSamples);
  for (Index k = 0; k < kSamples; ++k) {
    const double t = static_cast<double>(k) * kStep_s;
    x[k] = moved(0, 0.02, t) + 1e-4 * normal(random), a[k] = moved(2, 0.02, t) + 0.03 * normal(random) + 0.5;
  }
  const Guess g = fused_by_acceleration(&x, nullptr, a, kStep_s);
  double v_error = 0, x_error = 0;
  for (Index k = 0; k < kSamples; ++k) {
    const double t = static_cast<double>(k) * kStep_s;
    v_error += std::pow(g.v[k] - moved(1, 0.02, t), 2), x_error += std::pow(g.x[k] - moved(0, 0.02, t), 2);
  }
  EXPECT_LT(std::sqrt(v_error / kSamples), 1e-3);
  EXPECT_LT(std::sqrt(x_error / kSamples), 3e-5);
}

}  // namespace
}  // namespace diagnosis::runs
