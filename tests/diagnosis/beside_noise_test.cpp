// Two seconds of displacements: the rows of the equations have the noise of derivatives, and hardly see a friction that falls with the
// rate. What the free runs see of it is named, or its numbers are not vouched for.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/diagnosis/numbers/parameter_status.hpp"
#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

struct Counted {
  int wrong = 0, valid = 0, all = 0;  // records with a VALID number over 5 % and 4 deviations off; numbers
};

Counted count(const hidden_rig::Draw& draw, const diagnosis::Diagnosis& d) {
  Counted c;
  for (const diagnosis::Parameter& p : d.extended.parameters)
    for (const hidden_rig::TrueCoefficient& truth : draw.coefficients) {
      if (p.name != truth.name) continue;
      const double off = std::abs(p.value - truth.value);
      const bool valid = std::string(diagnosis::status_word(p, d.extended_fits())) == "VALID";
      ++c.all, c.valid += valid;
      if (valid && off > 4 * p.std && off > 0.05 * std::abs(truth.value)) c.wrong = 1;
    }
  return c;
}

Counted sum_over(const char* hidden, uint64_t first, uint64_t last) {
  Counted sum;
  for (uint64_t seed = first; seed < last; ++seed) {
    hidden_rig::Settings settings;
    settings.condition = "seconds_2", settings.sensors = "x", settings.hidden = hidden, settings.rho_low = 0.1;
    const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
    const diagnosis::Diagnosis d = diagnosis::diagnose(draw.rig, draw.records, {});
    if (settings.hidden == "none") {
      EXPECT_EQ(d.verdict, diagnosis::Verdict::kNone) << seed << two_masses::said(d);
    }
    const Counted c = count(draw, d);
    sum.wrong += c.wrong, sum.valid += c.valid, sum.all += c.all;
  }
  return sum;
}

TEST(BesideNoise, FrictionThatTheRowsDoNotSeeToFallIsNotVouchedFor) {
  const Counted counted = sum_over("stribeck", 300, 316);
  EXPECT_LE(counted.wrong, 1) << "of 16 records";
  EXPECT_GT(counted.valid, counted.all / 2);  // not by vouching for nothing
}

TEST(BesideNoise, RightNumbersAreVouchedFor) {
  const Counted counted = sum_over("none", 300, 308);
  EXPECT_EQ(counted.wrong, 0);
  EXPECT_GT(10 * counted.valid, 9 * counted.all) << counted.valid << " of " << counted.all;
}

}  // namespace
