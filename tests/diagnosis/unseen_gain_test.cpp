// Causes that few windows of the fit show: unseen windows say whether chance named them.
#include <gtest/gtest.h>

#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

// rms of the hidden force: 0.1 to 0.6 of the damping force of its link.
diagnosis::Diagnosis answer_to(uint64_t seed, const char* condition, const char* hidden) {
  hidden_rig::Settings settings;
  settings.condition = condition, settings.sensors = "xva", settings.hidden = hidden, settings.rho_low = 0.1;
  const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
  return diagnosis::diagnose(draw.rig, draw.records, {});
}

// One step of a stepped sine near the resonance that shows it is among the fitted windows: four deviations, of two degrees of
// freedom. Another is among the unseen ones, whose error falls by a third.
TEST(UnseenGain, OneStepOfASineAndAnotherNameADamping) {
  EXPECT_EQ(two_masses::said(answer_to(7100401, "stepped_sine", "cubic_damping")),
            "explained, cubic_damping on link 2-3");
}

// A damper that is a sixth harder one way than the other, in decays that are mostly rest: little of what is left, ten deviations.
TEST(UnseenGain, DecaysToRestTellADamperThatIsHarderOneWay) {
  const diagnosis::Diagnosis d = answer_to(7500001, "free_decay_to_rest", "asymmetric_viscous");
  ASSERT_EQ(d.causes.size(), 1u) << two_masses::said(d);
  EXPECT_EQ(d.causes[0].effect + " on " + d.causes[0].where, "asymmetric_viscous on link 1-2");
  EXPECT_LE(d.ambiguous_with.size(), 3u);
}

TEST(UnseenGain, NothingHiddenIsNamedInEither) {
  for (const uint64_t seed : {7100402u, 7100403u})
    for (const char* condition : {"stepped_sine", "free_decay_to_rest"})
      EXPECT_EQ(two_masses::said(answer_to(seed, condition, "none")), "none") << condition << " " << seed;
}

}  // namespace
