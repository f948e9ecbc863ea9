// Decays and blows: a stretch or two hold what there is to know of a damping law, and no scatter says how well they know it.
#include <gtest/gtest.h>

#include "record_outcome.hpp"

namespace {

const char* const kConditions[] = {"free_decay", "free_decay_to_rest", "hammer"};

// Laws that are told by how the rate differs between its largest stretches and the others.
TEST(FewStretches, WhatTheyShowOfALawIsNotExcluded) {
  int records = 0, bent = 0, wrong = 0;
  for (const char* hidden : {"displacement_dependent_damping", "quadratic_damping", "stribeck", "drifting_viscous"})
    for (const char* condition : kConditions)
      for (uint64_t seed = 8600; seed < 8612; ++seed, ++records) {
        hidden_rig::Settings settings;
        settings.hidden = hidden, settings.condition = condition, settings.sensors = "xa";
        const warrant_test::RecordOutcome outcome = warrant_test::outcome_of(seed, settings, 65535);
        bent += outcome.bent();
        wrong += outcome.valid_and_wrong();
      }
  EXPECT_GT(bent, records / 2);
  EXPECT_LE(wrong, records / 24) << "of " << records << ", 15 where such a law counted as excluded";
}

TEST(FewStretches, RightModelsKeepTheirNumbers) {
  int measurable = 0, valid = 0;
  for (const char* condition : kConditions)
    for (uint64_t seed = 8650; seed < 8662; ++seed) {
      hidden_rig::Settings settings;
      settings.condition = condition, settings.sensors = "xa";
      const warrant_test::RecordOutcome outcome = warrant_test::outcome_of(seed, settings, 65535);
      EXPECT_FALSE(outcome.suspect) << condition << seed;
      for (const auto& c : outcome.coefficients) {
        if (!c.measurable) continue;
        ++measurable;
        valid += c.valid();
      }
    }
  EXPECT_GT(measurable, 60);
  EXPECT_GE(100 * valid, 80 * measurable) << valid << " of " << measurable;
}

}  // namespace
