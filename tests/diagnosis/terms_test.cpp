// Forces of terms with a memory, against their solutions in closed form.
#include "host_sim/diagnosis/terms/terms.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "firmware/vocabulary/effect_table.hpp"
#include "host_sim/diagnosis/simulate/model.hpp"
#include "host_sim/vocabulary/law.hpp"

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

// A link that was coming back when its record starts: its bristles are bent that way. From the second sample on it moves on.
Steady turning() {
  Steady s;
  s.links[0].smooth_w[0] = -0.02;
  return s;
}

// Dahl: z = 1 - 2 exp(-u / L) after the turn. At u = 1 mm and L = 1 mm: 1 - 2/e. A link that moves on keeps its bristles bent.
TEST(Terms, DahlsBristlesBendOverTheirLength) {
  const Series z = turning().force(Kind::kPresliding, 1e-3, 0);
  EXPECT_EQ(z[0], -1);
  EXPECT_NEAR(z[51], 1 - 2 * std::exp(-1), 1e-12);
  for (double value : Steady().force(Kind::kPresliding, 1e-3, 0)) EXPECT_EQ(value, 1);
}

// LuGre adds sigma1 dz/dt, in units of the level: tau dz/dt = tau w / L * 2 exp(-u / L) after the turn. With tau = 0.05 s and
// w / L = 20 / s that is 2 exp(-u / L), which makes up for what Dahl's force lacks: 1 throughout.
TEST(Terms, LuGresBristlesAreDamped) {
  const Series z = turning().force(Kind::kPresliding, 1e-3, 0.05);
  for (Eigen::Index i = 1; i < z.size(); ++i) EXPECT_NEAR(z[i], 1, 1e-12);
}

// c(t) w with c = t, or tau (1 - exp(-t / tau)): at t = tau = 0.05 s 0.05 and 0.05 (1 - 1/e).
TEST(Terms, ADriftGoesOnOrLevelsOff) {
  EXPECT_NEAR(Steady().force(Kind::kDriftingViscous, 0, 0)[50], 0.02 * 0.05, 1e-15);
  EXPECT_NEAR(Steady().force(Kind::kDriftingViscous, 0.05, 0)[50], 0.02 * 0.05 * (1 - std::exp(-1)), 1e-15);
}

// exp(-zeta o t) cos(o t) and its sine, o = 2 pi 30 Hz, zeta = 0.001; a hum of 50 Hz does not die away. Ten minutes at 1 kHz.
TEST(Terms, ToneKeepsItsPhaseThroughALongRecord) {
  FusedRecord record;
  record.samples = 600000, record.period_s = 1e-3;
  record.motion.resize(1), record.force.resize(1);
  const auto force = [&](Kind kind) { return term_force(on_dof(kind, 0, 30, 0.001), record, {}); };
  const Series cosine = force(Kind::kResonanceCos), sine = force(Kind::kResonanceSin),
               hum = force(Kind::kForceHumSin50);
  const double pi = 3.14159265358979323846;
  for (Eigen::Index i : {0, 7, 1000, 20000, 599999}) {
    const double t = 1e-3 * static_cast<double>(i), left = std::exp(-0.001 * 60 * pi * t);
    EXPECT_NEAR(cosine[i], left * std::cos(60 * pi * t), 1e-9) << i;
    EXPECT_NEAR(sine[i], left * std::sin(60 * pi * t), 1e-9) << i;
    EXPECT_NEAR(hum[i], -std::sin(100 * pi * t), 1e-9) << i;
  }
}

// Every effect of the vocabulary that a rig file can lack has a term here; faults of channels are other terms. A held force
// is named from the delay that it looks like, and a channel's zero is free in every run.
TEST(Terms, EveryEffectOfTheVocabularyIsACandidate) {
  int same_law = 0;
  for (const firmware::EffectRow& row : firmware::kEffectTable) {
    if (row.role == firmware::EffectRole::kOwnTerm || row.place == firmware::EffectPlace::kChannel) continue;
    if (row.kind == firmware::EffectKind::kForceHold || row.kind == firmware::EffectKind::kDriveDeadBand) continue;
    SCOPED_TRACE(row.word.text);
    Kind kind;
    ASSERT_TRUE(kind_of_word(row.word.text, &kind));
    EXPECT_STREQ(word_of(kind), row.word.text);
    if (row.place != firmware::EffectPlace::kLink || vocabulary::law_of(row.kind).memories > 0 ||
        row.nature.memory != firmware::Memory::kNone)
      continue;
    if (kind == Kind::kMissingCoulomb || kind == Kind::kStribeck) continue;  // by the modes of the simulation
    const vocabulary::Shape shape{{0.02, 0.3}};
    for (const double u : {-0.05, 0.01, 0.03})
      for (const double w : {-0.4, 0.7}) {
        const double t_s = 1.5;
        EXPECT_NEAR(runs::law(kind, u, w, t_s, shape.p[0], shape.p[1]).force,
                    vocabulary::force(row.kind, vocabulary::point(row.kind, u, w, t_s, shape), shape).value, 1e-12);
      }
    ++same_law;
  }
  EXPECT_GE(same_law, 12);
}

}  // namespace
}  // namespace diagnosis
