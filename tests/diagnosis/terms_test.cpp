// Forces of terms with a memory, against their solutions in closed form.
#include "host_sim/diagnosis/terms.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace diagnosis {
namespace {

// A link that moves at 0.02 m/s for 0.1 s, sampled at 1 kHz.
struct Steady {
  FusedRecord record;
  std::vector<LinkMotion> links;
  Steady() : links(1) {
    record.samples = 100, record.period_s = 1e-3;
    LinkMotion& m = links[0];
    m.smooth_w = m.w = Series::Constant(100, 0.02);
    m.smooth_u = m.u = Series::LinSpaced(100, 0, 99 * 2e-5);
  }
  Series force(Kind kind, double shape, double shape2) const {
    Term term;
    term.kind = kind, term.link = 0, term.shape = shape, term.shape2 = shape2, term.given = true;
    return term_force(term, record, links);
  }
};

// Dahl: z = 1 - exp(-u / L). At u = 1 mm and L = 1 mm: 1 - 1/e.
TEST(Terms, DahlsBristlesBendOverTheirLength) {
  const Series z = Steady().force(Kind::kPresliding, 1e-3, 0);
  EXPECT_EQ(z[0], 0);
  EXPECT_NEAR(z[50], 1 - std::exp(-1), 1e-12);
}

// LuGre adds sigma1 dz/dt, in units of the level: tau dz/dt = tau w / L exp(-u / L). With tau = 0.05 s and w / L = 20 / s
// that is exp(-u / L), which makes up for what Dahl's force lacks: 1 throughout.
TEST(Terms, LuGresBristlesAreDamped) {
  const Series z = Steady().force(Kind::kPresliding, 1e-3, 0.05);
  for (Eigen::Index i = 0; i < z.size(); ++i) EXPECT_NEAR(z[i], 1, 1e-12);
}

// c(t) w with c = t, or tau (1 - exp(-t / tau)): at t = tau = 0.05 s 0.05 and 0.05 (1 - 1/e).
TEST(Terms, ADriftGoesOnOrLevelsOff) {
  EXPECT_NEAR(Steady().force(Kind::kDriftingViscous, 0, 0)[50], 0.02 * 0.05, 1e-15);
  EXPECT_NEAR(Steady().force(Kind::kDriftingViscous, 0.05, 0)[50], 0.02 * 0.05 * (1 - std::exp(-1)), 1e-15);
}

}  // namespace
}  // namespace diagnosis
