// The fixed-point estimator against the same estimator in double precision, on tables drawn at random: agreement to
// 1e-6 of each value and standard deviation.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/identification/double_reference.hpp"
#include "tests/identification/hand_table.hpp"

namespace {

using firmware::TermKind;
using hand::DofEntry;
using hand::HandTable;

// A chain of three DOFs with four dampers and one friction, as the paper's Fig. 4; energies at random, with noise of 1
// % that the discrepancies share. scale: of all energies, from rigs of micrograms to tons.
void fill(HandTable& t, bool periodic, int batches, double scale, unsigned seed) {
  std::mt19937 random(seed);
  const auto draw = [&] { return (static_cast<double>(random()) / 4294967296.0 - 0.5) * 2.0; };
  const double truth[] = {20, 18, 22, 19, 1.5};
  const std::vector<std::vector<int>> unknowns = {{0, 1}, {1, 2}, {2, 3, 4}};
  for (int l = 0; l < 3; ++l) {
    t.level(periodic);
    std::vector<std::vector<double>> mean;
    for (const std::vector<int>& of_dof : unknowns) {
      mean.emplace_back();
      for (size_t k = 0; k < of_dof.size(); ++k) mean.back().push_back(1.5 + draw());
    }
    for (int b = 0; b < batches; ++b) {
      std::vector<DofEntry> dofs(3);
      std::vector<double> noise;
      for (int i = 0; i < 6; ++i) noise.push_back(draw());
      for (size_t i = 0; i < 3; ++i) {
        const double motion = periodic ? 1.0 : 1.0 + 0.9 * draw();
        for (size_t k = 0; k < unknowns[i].size(); ++k) {
          dofs[i].columns.push_back(scale * motion * (mean[i][k] + (periodic ? 0.01 : 0.5) * draw()));
          dofs[i].rhs += dofs[i].columns.back() * truth[unknowns[i][k]];
        }
        dofs[i].motion = motion * scale;
        dofs[i].kinetic = scale * 0.02 * (noise[2 * i] + 0.3 * draw());
        dofs[i].elastic = scale * 0.01 * (noise[2 * i + 1] + 0.3 * draw());
        dofs[i].rhs +=
            scale * (0.3 * noise[2 * i] - 0.2 * noise[2 * i + 1] + 0.1 * noise[(2 * i + 2) % 6] + 0.05 * draw());
      }
      t.batch(dofs);
    }
  }
}

HandTable chain() {
  HandTable t(3, {TermKind::kViscous, TermKind::kViscous, TermKind::kViscous, TermKind::kViscous, TermKind::kCoulomb},
              {{0}, {0, 1}, {1, 2}, {2}, {2}});
  t.link(0, firmware::kGroundNode);
  t.link(0, 1);
  t.link(1, 2);
  t.link(2, firmware::kGroundNode);
  t.link(2, firmware::kGroundNode);
  return t;
}

void expect_agreement(bool periodic, int batches, double scale, unsigned seed) {
  HandTable t = chain();
  fill(t, periodic, batches, scale, seed);
  t.identify();
  const reference::Result expected = reference::estimate(t.configuration, *t.table);
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(t.value(k) / expected.value(k), 1.0, 1e-6) << "unknown " << k << " seed " << seed;
    EXPECT_NEAR(t.deviation(k) / expected.deviation(k), 1.0, 1e-6) << "unknown " << k << " seed " << seed;
  }
}

}  // namespace

TEST(Agreement, PeriodicLevels) {
  for (unsigned seed = 1; seed <= 10; ++seed) expect_agreement(true, 50, 1.0, seed);
}

TEST(Agreement, IntervalRows) {
  for (unsigned seed = 1; seed <= 10; ++seed) expect_agreement(false, 40, 1.0, seed);
}

TEST(Agreement, EnergiesOfAnyScale) {
  expect_agreement(true, 50, 1e-18, 3);
  expect_agreement(false, 40, 1e15, 4);
}

TEST(Agreement, FewBatchesLimitTheReduction) {
  for (unsigned seed = 1; seed <= 5; ++seed) expect_agreement(true, 9, 1.0, seed);
}
