// Friction that is asked for where there is none.
#include <gtest/gtest.h>

#include "hal/rig_file/scaled_double.hpp"
#include "verdict_counts.hpp"

namespace {

using firmware::EstimateStatus;
using rig_file::to_double;

// Two-sided 95 % intervals of right numbers that are nought lie wholly below it in one case of 40. That is no reason to withdraw a rig, and
// none to rely on such a number. Of 120 about three are expected; that there is none at all has a chance of one in 20.
TEST(Nought, AnIntervalBelowItIsUntestedWithItsNeighboursAndAccusesNobody) {
  int asked = 0, below = 0;
  for (uint64_t seed = 7650; asked < 120; ++seed) {
    hidden_rig::Settings settings;
    settings.masses = 2;
    hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
    for (size_t l = 0; l < draw.rig.links.size(); ++l)
      if (draw.true_rig.links[l].F == 0) draw.rig.links[l].coulomb_N.estimate = true;
    const warrant_test::CoreRun run = warrant_test::run_core(draw);
    const firmware::Estimates& e = run.core->estimates();
    for (int t = 0; t < run.configuration.term_count; ++t) {
      const firmware::Term& term = run.configuration.terms[t];
      if (term.kind != firmware::TermKind::kCoulomb || term.unknown < 0) continue;
      if (draw.true_rig.links[term.place].F != 0) continue;
      const firmware::ParameterEstimate& p = e.parameters[term.unknown];
      ++asked;
      if (!p.ci95_high.is_negative()) continue;
      ++below;
      EXPECT_NE(p.status, EstimateStatus::kValid) << seed;
      // nor on what stands beside it: the coefficients of links that meet one of its masses
      const firmware::LinkConfiguration& own = run.configuration.links[term.place];
      for (int other = 0; other < run.configuration.term_count; ++other) {
        const firmware::Term& beside = run.configuration.terms[other];
        if (beside.unknown < 0 || beside.kind == firmware::TermKind::kMass) continue;
        const firmware::LinkConfiguration& link = run.configuration.links[beside.place];
        const auto is_mass = [&](int node) { return node < run.configuration.dof_count; };
        for (const int a : {own.node_a, own.node_b})
          if (is_mass(a) && (link.node_a == a || link.node_b == a)) {
            EXPECT_NE(e.parameters[beside.unknown].status, EstimateStatus::kValid) << seed;
          }
      }
    }
    EXPECT_FALSE(warrant_test::suspect(e)) << seed;
  }
  EXPECT_GT(below, 0);
  EXPECT_LE(below, 10);
}

// Friction of -1 +- 0.1 N accuses the model, which lacks something. Read from its end, a record begins where friction holds springs bent by a
// force that nobody knows: that makes the same number, of a right model.
TEST(Nought, ARestThatSpringsPullAtAccusesNobody) {
  hidden_rig::Settings settings;
  settings.masses = 1;
  hidden_rig::Draw draw = hidden_rig::make_draw(7690, settings);
  for (rig_file::Link& link : draw.rig.links) link.coulomb_N.estimate = true;
  const warrant_test::CoreRun run = warrant_test::run_core(draw);
  const firmware::ScoreTests& tests = run.core->score_tests();
  for (const bool back : {false, true}) {
    firmware::CoreConfiguration configuration = run.configuration;
    configuration.time_runs_back = back;
    firmware::Estimates estimates = run.core->estimates();
    for (int t = 0; t < configuration.term_count; ++t) {
      if (configuration.terms[t].kind != firmware::TermKind::kCoulomb) continue;
      firmware::ParameterEstimate& p = estimates.parameters[configuration.terms[t].unknown];
      p.value = firmware::Scaled::from_int(back ? 1 : -1);
      p.std = firmware::Scaled::ratio(1, 10);
      p.ci95_low = p.value - p.std * 2, p.ci95_high = p.value + p.std * 2;
    }
    give_verdict(configuration, tests.sums(), tests.test(), {true, true, 2}, estimates);
    for (int k = 0; k < estimates.unknown_count; ++k)
      EXPECT_EQ(estimates.parameters[k].status == EstimateStatus::kModelSuspect, !back) << k;
    EXPECT_NE(estimates.parameters[0].status, EstimateStatus::kValid);
  }
}

}  // namespace
