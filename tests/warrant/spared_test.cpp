// Which numbers a named cause leaves VALID: those that it does not bend.
#include <gtest/gtest.h>

#include "hal/rig_file/scaled_double.hpp"
#include "verdict_counts.hpp"

namespace {

using firmware::EffectKind;
using firmware::EstimateStatus;
using hidden_rig::Settings;

struct Counts {
  int named = 0, suspect = 0, valid = 0, wrong = 0;
};

// Of the records in which this very cause is named: their coefficients.
Counts counts_of(const char* hidden, EffectKind kind, uint64_t first, int masses) {
  Counts counts;
  for (uint64_t seed = first; seed < first + 12; ++seed) {
    Settings settings;
    settings.hidden = hidden, settings.masses = masses, settings.rho_low = 0.2;
    const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
    const warrant_test::CoreRun run = warrant_test::run_core(draw);
    const firmware::Estimates& e = run.core->estimates();
    if (e.warrant.named.cause != firmware::cause_of(kind) || e.warrant.naming != firmware::Naming::kExplains) continue;
    ++counts.named;
    counts.suspect += warrant_test::suspect(e);
    counts.wrong += warrant_test::valid_and_wrong(draw, e);
    for (int k = 0; k < e.unknown_count; ++k) counts.valid += e.parameters[k].status == EstimateStatus::kValid;
  }
  return counts;
}

// A constant force does no work on a motion about a place: F0 times the way from a window's begin to its end, which is nought on the
// mean. Dampers are not bent, whatever reads their rates.
TEST(Spared, AConstantForceWithdrawsNoDamper) {
  const Counts counts = counts_of("force_offset", EffectKind::kForceOffset, 7700, 2);
  EXPECT_GE(counts.named, 9);
  EXPECT_LE(counts.suspect, 2);
  EXPECT_GE(counts.valid, 2 * counts.named);
  EXPECT_EQ(counts.wrong, 0);
}

// c w |w| is c sqrt(8 / pi) rms(w) w on the mean: its own damper is that much too large, by all its strength, and always withdrawn.
TEST(Spared, ADampingLawWithdrawsItsLinksDamperAndNotAllOthers) {
  const Counts counts = counts_of("quadratic_damping", EffectKind::kQuadraticDamping, 7800, 4);
  EXPECT_GE(counts.named, 6);
  EXPECT_EQ(counts.suspect, counts.named);
  EXPECT_GE(counts.valid, counts.named);
  EXPECT_EQ(counts.wrong, 0);
}

// A mode that the rig file lacks is a mass below its frequency and a spring above it, and a damper besides.
TEST(Spared, NothingBesideASpringOrAMassThatIsWrong) {
  for (const auto& [hidden, kind] :
       {std::pair{"stiffness_error", EffectKind::kStiffnessError}, std::pair{"mass_error", EffectKind::kMassError}}) {
    const Counts counts = counts_of(hidden, kind, 7900, 3);
    EXPECT_GE(counts.named, 6) << hidden;
    EXPECT_EQ(counts.suspect, counts.named) << hidden;
    EXPECT_EQ(counts.valid, 0) << hidden;
  }
}

}  // namespace
