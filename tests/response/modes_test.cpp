// Modes against closed forms and against the characteristic polynomial, and their intervals against draws.
#include "host_sim/response/modes.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

using namespace host_sim;

namespace {

rig_file::RigModel chain(const std::vector<double>& masses, const std::vector<double>& k,
                         const std::vector<double>& c) {
  rig_file::RigModel rig;
  for (double mass : masses) {
    rig.dofs.emplace_back();
    rig.dofs.back().mass_kg.value = mass;
  }
  for (size_t l = 0; l < k.size(); ++l) {
    rig_file::Link link;
    link.a = l < masses.size() ? static_cast<int>(l) + 1 : static_cast<int>(masses.size());
    link.b = l < masses.size() ? static_cast<int>(l) : 0;
    link.stiffness_N_m.value = k[l];
    link.viscous_N_s_m.value = c[l];
    rig.links.push_back(link);
  }
  return rig;
}

// |det(M s^2 + C s + K)| of a chain beside the product of its diagonal's sizes: zero where s is an eigenvalue. Built here
// from the springs and dampers directly.
double determinant_share(const std::vector<double>& m, const std::vector<double>& k, const std::vector<double>& c,
                         std::complex<double> s) {
  const auto n = static_cast<Eigen::Index>(m.size());
  Eigen::MatrixXcd dynamic = Eigen::MatrixXcd::Zero(n, n);
  double size = 1.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto here = static_cast<size_t>(i);
    const std::complex<double> left = k[here] + c[here] * s;
    const std::complex<double> right = here + 1 < k.size() ? k[here + 1] + c[here + 1] * s : 0.0;
    dynamic(i, i) = m[here] * s * s + left + right;
    size *= std::abs(m[here] * s * s) + std::abs(left) + std::abs(right);
    if (i + 1 < n) dynamic(i, i + 1) = dynamic(i + 1, i) = -right;
  }
  return std::abs(dynamic.determinant()) / size;
}

// One mass, k = 100 N/m: w = 10 rad/s, critical damping 20 N s/m. What has no variance is not exact: the ratio goes with the damper, the
// frequency does not. Near 20 the mode goes within a step of a tenth of 30 N s/m, and nothing is known of it.
TEST(Modes, WithoutAVarianceThereIsNoInterval) {
  rig_file::RigModel model = chain({1.0}, {100.0, 0.0}, {0.0, 0.0});
  model.links[0].viscous_N_s_m.estimate = true;
  const auto known = modes_with_intervals(model, {2.0}, {{0.01}}).at(0);
  EXPECT_NEAR(known.damping_ratio.high - known.damping_ratio.value, 1.96 * 0.1 / 20, 1e-4);
  const auto unknown = modes_with_intervals(model, {2.0}, {{0.0}}).at(0);
  EXPECT_NEAR(unknown.damping_ratio.value, 0.1, 1e-9);
  EXPECT_TRUE(std::isnan(unknown.damping_ratio.low));
  EXPECT_NEAR(unknown.frequency_Hz.low, 10 / (2 * M_PI), 1e-6);
  const auto vanishing = modes_with_intervals(model, {19.0}, {{900.0}}).at(0);
  EXPECT_TRUE(std::isnan(vanishing.frequency_Hz.low));
  EXPECT_TRUE(std::isnan(vanishing.damping_ratio.high));
}

}  // namespace

// Masses 1 and 1, springs 2 (to ground), 3 (between): eigenvalues of (5 -3; -3 3) are 4 -+ sqrt(10), the least 0.837722.
TEST(Modes, SlowestOfAChain) {
  rig_file::RigModel rig = chain({1, 1}, {2, 3}, {0, 0});
  EXPECT_NEAR(slowest_mode_Hz(rig), std::sqrt(4 - std::sqrt(10.0)) / (2.0 * M_PI), 1e-12);
  rig.links[0].stiffness_N_m.estimate = true;  // may be nought: the two move together against nothing
  EXPECT_EQ(slowest_mode_Hz(rig), 0.0);
  rig.links[0].stiffness_N_m.estimate = false;
  rig.dofs[1].mass_kg.estimate = true;  // may be as heavy as it likes
  EXPECT_EQ(slowest_mode_Hz(rig), 0.0);
}

// m = 2, k = 800, c = 1.5: omega = 20, zeta = 1.5 / (2 sqrt(1600)) = 0.01875.
TEST(Modes, OneMass) {
  const std::vector<Mode> modes = modes_of(chain({2.0}, {800.0}, {1.5}));
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_NEAR(modes[0].frequency_Hz, 20.0 / (2.0 * M_PI), 1e-12);
  EXPECT_NEAR(modes[0].damping_ratio, 0.01875, 1e-12);
  EXPECT_EQ(modes[0].shape[0], 1.0);
}

// Two equal masses between equal springs: together with k / m, against each other with 3 k / m.
TEST(Modes, TwoEqualMasses) {
  const std::vector<Mode> modes = modes_of(chain({1.0, 1.0}, {100.0, 100.0, 100.0}, {0.0, 0.0, 0.0}));
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_NEAR(modes[0].frequency_Hz, 10.0 / (2.0 * M_PI), 1e-10);
  EXPECT_NEAR(modes[1].frequency_Hz, std::sqrt(300.0) / (2.0 * M_PI), 1e-10);
  EXPECT_NEAR(modes[0].shape[0].real() * modes[0].shape[1].real(), 1.0, 1e-9);
  EXPECT_NEAR(modes[1].shape[0].real() * modes[1].shape[1].real(), -1.0, 1e-9);
}

TEST(Modes, RigidBodiesCreepingAndMasslessRigsHaveNone) {
  EXPECT_EQ(modes_of(chain({1.0, 2.0}, {0.0, 50.0}, {0.0, 0.1})).size(), 1u);  // free in space: one of two
  EXPECT_TRUE(modes_of(chain({1.0}, {1.0}, {10.0})).empty());                  // overdamped
  EXPECT_TRUE(modes_of(chain({0.0}, {1.0}, {1.0})).empty());
}

TEST(Modes, AreRootsOfTheCharacteristicPolynomial) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> share(0.5, 2.0);
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<double> m, k, c;
    const int n = 1 + trial % 8;
    for (int i = 0; i < n; ++i) m.push_back(share(random));
    for (int i = 0; i <= n; ++i) k.push_back(1e4 * share(random)), c.push_back(5.0 * share(random));
    const std::vector<Mode> modes = modes_of(chain(m, k, c));
    ASSERT_EQ(modes.size(), static_cast<size_t>(n));
    for (const Mode& mode : modes) {
      const double omega = 2.0 * M_PI * mode.frequency_Hz, zeta = mode.damping_ratio;
      const std::complex<double> s(-zeta * omega, omega * std::sqrt(1.0 - zeta * zeta));
      EXPECT_LT(determinant_share(m, k, c, s), 1e-9);
    }
  }
}

// Coefficients drawn with a known covariance: the interval around each draw holds the true value in 95 of 100 cases.
TEST(Modes, IntervalsHold) {
  rig_file::RigModel model = chain({1.5, 1.3}, {1e4, 1e4, 1e4}, {0.0, 0.0, 0.0});
  for (rig_file::Link& link : model.links) link.viscous_N_s_m.estimate = true;
  const std::vector<double> truth = {20.0, 15.0, 25.0};
  Eigen::Matrix3d root;  // of the covariance: the second estimate moves against the first
  root << 0.8, 0.0, 0.0, -0.6, 0.5, 0.0, 0.1, 0.2, 0.7;
  const Eigen::Matrix3d covariance = root * root.transpose();
  std::vector<std::vector<double>> rows(3, std::vector<double>(3));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) rows[static_cast<size_t>(i)][static_cast<size_t>(j)] = covariance(i, j);
  const std::vector<Mode> exact = modes_of(rig_file::with_values(model, truth));
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  int held = 0;
  constexpr int kDraws = 400;
  for (int draw = 0; draw < kDraws; ++draw) {
    const Eigen::Vector3d error = root * Eigen::Vector3d(normal(random), normal(random), normal(random));
    std::vector<double> values = truth;
    for (int i = 0; i < 3; ++i) values[static_cast<size_t>(i)] += error(i);
    const std::vector<UncertainMode> modes = modes_with_intervals(model, values, rows);
    ASSERT_EQ(modes.size(), 2u);
    for (size_t m = 0; m < 2; ++m)
      held +=
          modes[m].damping_ratio.low <= exact[m].damping_ratio && exact[m].damping_ratio <= modes[m].damping_ratio.high;
  }
  // 800 Bernoulli trials at 0.95, in pairs: standard deviation at most sqrt(2 * 800 * 0.05 * 0.95) = 8.7; four of them.
  EXPECT_NEAR(held, 760, 35);
}
