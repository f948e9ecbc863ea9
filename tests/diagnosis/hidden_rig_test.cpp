// The draws' own integrator: what it writes must obey the equations of motion.
#include <gtest/gtest.h>

#include <cmath>

#include "draw.hpp"

namespace hidden {
namespace {

// Two masses, three links that all have friction. In this draw all of them once came to rest in the same substep and
// stayed so for good, with a force of 60 N held by frictions of 1 to 2 N.
TEST(HiddenRig, FrictionNeverHoldsMoreThanItsLevel) {
  Settings settings;
  settings.hide = Hide::kNothing, settings.noise = 1e-7;
  const Draw draw = make_draw(9200064, settings);
  using host_sim::Quantity;
  const auto channel = [&](Quantity q, int dof) -> const std::vector<double>& {
    return draw.record.find(q, dof)->values;
  };
  const auto &x1 = channel(Quantity::kDisplacement, 1), &v1 = channel(Quantity::kVelocity, 1),
             &a1 = channel(Quantity::kAcceleration, 1);
  const auto &x2 = channel(Quantity::kDisplacement, 2), &v2 = channel(Quantity::kVelocity, 2),
             &a2 = channel(Quantity::kAcceleration, 2);
  const auto& f = channel(Quantity::kForce, 1);
  const std::vector<double>& m = draw.true_rig.mass_kg;
  const std::vector<TrueLink>& l = draw.true_rig.links;  // 1-0, 1-2, 2-0
  ASSERT_EQ(m.size(), 2u);
  ASSERT_EQ(l.size(), 3u);
  double most_1 = 0, most_2 = 0;
  for (size_t i = 0; i < f.size(); ++i) {
    const double between = l[1].k * (x1[i] - x2[i]) + l[1].c * (v1[i] - v2[i]);
    most_1 = std::max(most_1, std::abs(f[i] - m[0] * a1[i] - l[0].k * x1[i] - l[0].c * v1[i] - between));
    most_2 = std::max(most_2, std::abs(between - m[1] * a2[i] - l[2].k * x2[i] - l[2].c * v2[i]));
  }
  EXPECT_LT(most_1, l[0].F + l[1].F + 1e-3);
  EXPECT_LT(most_2, l[1].F + l[2].F + 1e-3);
  EXPECT_GT(most_1, 0.9 * (l[0].F + l[1].F));  // and slides at it
}

}  // namespace
}  // namespace hidden
