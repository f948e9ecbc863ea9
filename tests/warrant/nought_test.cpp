// Friction that is asked for where there is none.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

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
    give_verdict(configuration, tests.sums(), tests.test(), {true, 2}, estimates);
    for (int k = 0; k < estimates.unknown_count; ++k)
      EXPECT_EQ(estimates.parameters[k].status == EstimateStatus::kModelSuspect, !back) << k;
    EXPECT_NE(estimates.parameters[0].status, EstimateStatus::kValid);
  }
}

// Two masses of 1 kg on 700, 1200 (between them) and 550 N/m are let go at 3 and -1.5 mm. Friction of 0.01 N between them ends the way against
// each other, and holds the middle spring bent by up to 8 um; both come to rest together. h 0.1 ms; friction's impulse is what ends the
// relative motion, at the most F h. Velocities of the leapfrog's half steps are averaged. Noise of 0.3 % of each channel's rms.
hidden_rig::Draw held_at_rest(uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  constexpr double h = 1e-4, F = 0.01;
  double x1 = 3e-3, x2 = -1.5e-3, v1 = 0, v2 = 0;
  std::vector<double> columns[3];
  for (int k = 0; k < 6000; ++k) {
    columns[0].push_back(x1), columns[1].push_back(x2), columns[2].push_back(0.5 * v2);
    for (int i = 0; i < 25; ++i) {
      const double middle = 1200 * (x1 - x2) + 1.5 * (v1 - v2);
      v1 += h * (-700 * x1 - 3 * v1 - middle), v2 += h * (-550 * x2 - 2 * v2 + middle);
      const double impulse = std::clamp(0.5 * (v1 - v2), -F * h, F * h);
      v1 -= impulse, v2 += impulse;
      if (i == 0) columns[2].back() += 0.5 * v2;
      x1 += h * v1, x2 += h * v2;
    }
  }
  hidden_rig::Draw draw;
  host_sim::Record record;
  record.sample_period_s = 25 * h;
  const char* const names[] = {"displacement_1_m", "displacement_2_m", "velocity_2_m_s"};
  for (int c = 0; c < 3; ++c) {
    const double noise = 3e-3 * hidden_rig::rms(columns[c]);
    for (double& value : columns[c]) value += noise * normal(random);
    const auto quantity = c == 2 ? host_sim::Quantity::kVelocity : host_sim::Quantity::kDisplacement;
    record.channels.push_back({names[c], quantity, c == 0 ? 1 : 2, columns[c]});
  }
  draw.records.push_back(record);
  draw.rig.dofs.resize(2);
  for (rig_file::Dof& dof : draw.rig.dofs) dof.mass_kg.value = 1;
  const double stiffness_N_m[] = {700, 1200, 550};
  for (int l = 0; l < 3; ++l) {
    rig_file::Link link;
    link.a = l == 2 ? 2 : 1, link.b = l == 1 ? 2 : rig_file::kGround;
    link.stiffness_N_m.value = stiffness_N_m[l];
    link.viscous_N_s_m.estimate = true;
    link.coulomb_N.estimate = l == 1;
    draw.rig.links.push_back(link);
  }
  return draw;
}

TEST(Nought, FrictionThatHoldsASpringBentIsNoConstantForce) {
  for (uint32_t seed = 1; seed <= 4; ++seed) {
    const warrant_test::CoreRun run = warrant_test::run_core(held_at_rest(seed));
    const firmware::Estimates& e = run.core->estimates();
    EXPECT_FALSE(warrant_test::suspect(e))
        << seed << " " << static_cast<int>(e.warrant.named.cause) << " " << to_double(e.warrant.named.size);
  }
}

// One mass, its damper and its friction are asked for. A mass of 0.01 +- 0.02 kg that the data do not determine drowns in noise: what stands
// in its equation has noise in the inertia's place (a gravity torque of 4 N m came out as -0.7, VALID). One that is surely there, or
// that the data determine, says nothing.
TEST(Nought, AMassThatDrownsLeavesNothingOfItsEquationValid) {
  hidden_rig::Settings settings;
  settings.masses = 1;
  hidden_rig::Draw draw = hidden_rig::make_draw(7690, settings);
  draw.rig.dofs[0].mass_kg.estimate = true;
  const warrant_test::CoreRun run = warrant_test::run_core(draw);
  const firmware::ScoreTests& tests = run.core->score_tests();
  const auto untested = [&](double mass, EstimateStatus status) {
    firmware::Estimates estimates = run.core->estimates();
    int mass_at = -1, count = 0;
    for (int t = 0; t < run.configuration.term_count; ++t)
      if (run.configuration.terms[t].kind == firmware::TermKind::kMass) mass_at = run.configuration.terms[t].unknown;
    firmware::ParameterEstimate& m = estimates.parameters[mass_at];
    m.value = rig_file::to_scaled(mass), m.std = firmware::Scaled::ratio(1, 50), m.status = status;
    m.ci95_low = m.value - m.std * 2, m.ci95_high = m.value + m.std * 2;
    give_verdict(run.configuration, tests.sums(), tests.test(), {true, 2}, estimates);
    for (int k = 0; k < estimates.unknown_count; ++k)
      count += k != mass_at && estimates.parameters[k].status == EstimateStatus::kUntested;
    return count;
  };
  EXPECT_EQ(untested(0.01, EstimateStatus::kIllConditioned), run.core->estimates().unknown_count - 1);
  EXPECT_EQ(untested(0.05, EstimateStatus::kIllConditioned), 0);
  EXPECT_EQ(untested(0.01, EstimateStatus::kValid), 0);
}

}  // namespace
