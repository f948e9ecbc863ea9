// The energies of a rig against sums in long double over the same codes, and the exactness of sampled equations of motion.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "firmware/estimator_core.hpp"

namespace {

using namespace firmware;

double to_double(Scaled value) { return std::ldexp(static_cast<double>(value.mantissa), value.exponent); }
double to_double(PackedScaled value) { return to_double(unpack(value)); }

void add_term(CoreConfiguration& c, TermKind kind, int place, int unknown, int64_t value) {
  Term& term = c.terms[c.term_count++];
  term.kind = kind;
  term.place = static_cast<uint8_t>(place);
  term.unknown = static_cast<int8_t>(unknown);
  term.value = Scaled::from_int(value);
}

// Two masses: ground - 1 - 2; every code is worth 2^-10 of its unit. Unknown: viscous[1-0], viscous[1-2], coulomb[1-2].
std::unique_ptr<CoreConfiguration> two_masses(bool acceleration) {
  auto c = std::make_unique<CoreConfiguration>();
  c->dof_count = 2;
  c->link_count = 2;
  c->unknown_count = 3;
  c->sample_period_s = Scaled::ratio(1, 1024);
  c->links[0] = {0, kGroundNode};
  c->links[1] = {0, 1};
  for (int i = 0; i < 2; ++i)
    for (int q = 0; q < kQuantities; ++q) {
      ChannelConfiguration& channel = c->channels[i][q];
      channel.present = q != static_cast<int>(Quantity::kAcceleration) || acceleration;
      channel.unit_per_code = Scaled::from_int(1, -10);
    }
  add_term(*c, TermKind::kMass, 0, -1, 3);
  add_term(*c, TermKind::kMass, 1, -1, 2);
  add_term(*c, TermKind::kStiffness, 0, -1, 7);
  add_term(*c, TermKind::kStiffness, 1, -1, 5);
  add_term(*c, TermKind::kViscous, 0, 0, 0);
  add_term(*c, TermKind::kViscous, 1, 1, 0);
  add_term(*c, TermKind::kCoulomb, 1, 2, 0);
  copy_measured_signals(*c);
  return c;
}

int sign(int64_t value) { return (value > 0) - (value < 0); }

// Codes that obey the equations of motion exactly, for any motion: f = m a + k u + c w + F sgn(w), c = 4, 6, F = 1000 codes.
RawSample sample_at(uint32_t n) {
  RawSample s;
  s.sequence = n;
  const double t = n * 0.01;
  const double phase[2] = {0.3, 1.9}, frequency[2] = {3.1, 4.7};
  for (int i = 0; i < 2; ++i) {
    s.code[i][1] = static_cast<int32_t>(std::lround(1e5 * std::sin(frequency[i] * t + phase[i])));
    s.code[i][2] = static_cast<int32_t>(std::lround(8e4 * std::cos(frequency[i] * t + phase[i])));
    s.code[i][3] = static_cast<int32_t>(std::lround(-6e4 * std::sin(frequency[i] * t + phase[i])));
  }
  const int32_t u = s.code[0][1] - s.code[1][1], w = s.code[0][2] - s.code[1][2];
  const int32_t friction = 1000 * sign(w);
  s.code[0][0] = 3 * s.code[0][3] + 7 * s.code[0][1] + 5 * u + 4 * s.code[0][2] + 6 * w + friction;
  s.code[1][0] = 2 * s.code[1][3] - 5 * u - 6 * w - friction;
  return s;
}

Batch total(const BatchTable& table, int level) {
  Batch sum = table.level[level].batch[0];
  for (int b = 1; b < table.level[level].batch_count; ++b) accumulate(sum, table.level[level].batch[b], table.layout);
  return sum;
}

std::unique_ptr<EstimatorCore> run(const CoreConfiguration& c, uint32_t samples) {
  auto core = std::make_unique<EstimatorCore>(c);
  core->begin_level();
  for (uint32_t n = 0; n < samples; ++n) core->push(sample_at(n));
  core->end_level();
  return core;
}

}  // namespace

TEST(EnergySums, SampledEquationsOfMotionBalanceToTheLastBit) {
  // Plain and displacement weights: 4 and 6 N s/m, F = 1000 codes * 2^-10 N. (The instrument's friction column is
  // extrapolated between two sign streams; the accuracy tests judge it.)
  const auto c = two_masses(true);
  const auto core = run(*c, 3000);
  const Batch sum = total(core->table(), 0);
  EXPECT_EQ(sum.samples, 3000u - static_cast<unsigned>(core->margin_samples()));
  const double p[3] = {4.0, 6.0, 1000.0 / 1024.0};
  for (int q : {0, 2}) {
    for (int i = 0; i < 2; ++i) {
      double left = 0.0, size = 0.0;
      for (int s = core->table().layout.first[i]; s < core->table().layout.first[i + 1]; ++s) {
        const double energy = to_double(sum.column[q][s]) * p[core->table().layout.unknown[s]];
        left += energy;
        size += std::fabs(energy);
      }
      EXPECT_NEAR(left, to_double(sum.dof[i].rhs[q]), 1e-12 * size) << "weight " << q << " dof " << i;
    }
  }
}

TEST(EnergySums, AgreeWithLongDoubleSumsOfTheSameCodes) {
  const auto c = two_masses(true);
  const uint32_t samples = 1500;
  const auto core = run(*c, samples);
  const Batch sum = total(core->table(), 0);
  const long double h = 1.0L / 1024.0L, unit = 1.0L / 1024.0L;
  std::vector<RawSample> s;
  for (uint32_t n = 0; n < samples; ++n) s.push_back(sample_at(n));
  const auto z = [&](size_t n) {
    return (-s[n - 2].code[0][2] + 4.0L * s[n - 1].code[0][2] + 4.0L * s[n + 1].code[0][2] - s[n + 2].code[0][2]) /
           6.0L;
  };
  // Trapezoid from sample 3 to sample 1495, with end slopes by central differences (Gregory to second order).
  const auto integral = [&](auto f) {
    const size_t a = 3, b = samples - 4;
    long double sum_of = 0.5L * (f(a) + f(b));
    for (size_t n = a + 1; n < b; ++n) sum_of += f(n);
    return h * (sum_of - (f(b + 1) - f(b - 1)) / 24.0L + (f(a + 1) - f(a - 1)) / 24.0L);
  };
  const auto v1 = [&](size_t n) { return unit * s[n].code[0][2]; };
  const auto v2 = [&](size_t n) { return unit * s[n].code[1][2]; };
  const auto friction = [&](size_t n) { return static_cast<long double>(sign(s[n].code[0][2] - s[n].code[1][2])); };
  const RowLayout& layout = core->table().layout;
  ASSERT_EQ(layout.first[1], 3);  // DOF 1: viscous[1-0], viscous[1-2], coulomb[1-2]
  const auto near = [](PackedScaled got, long double want) {
    EXPECT_NEAR(to_double(got), static_cast<double>(want), 1e-10 * std::fabs(static_cast<double>(want)));
  };
  near(sum.column[0][0], integral([&](size_t n) { return v1(n) * v1(n); }));
  near(sum.column[0][1], integral([&](size_t n) { return v1(n) * (v1(n) - v2(n)); }));
  near(sum.column[0][2], integral([&](size_t n) { return v1(n) * friction(n); }));
  near(sum.column[0][3], integral([&](size_t n) { return v2(n) * (v2(n) - v1(n)); }));
  near(sum.column[0][4], integral([&](size_t n) { return -v2(n) * friction(n); }));
  // The instrument's equations count the samples whose friction has a clear sign: the rate of the neighbours is over four times
  // the mean difference between it and the rate, and the rate agrees.
  std::vector<int> clear(samples, 0);
  long double differences = 0;
  for (size_t n = 2; n + 2 < samples; ++n) {
    const auto w = [&](size_t i) { return static_cast<long double>(s[i].code[0][2] - s[i].code[1][2]); };
    const long double around = (4 * (w(n - 1) + w(n + 1)) - w(n - 2) - w(n + 2)) / 6;
    differences += std::fabs(w(n) - around);
    if (std::fabs(around) * static_cast<long double>(n - 1) > 4 * differences && around * w(n) > 0)
      clear[n] = around > 0 ? 1 : -1;
  }
  const auto q = [&](size_t n) { return clear[n] != 0 ? z(n) : 0; };
  near(sum.column[1][1], integral([&](size_t n) { return unit * q(n) * (v1(n) - v2(n)); }));
  near(sum.column[1][2], integral([&](size_t n) { return unit * q(n) * clear[n]; }));
  near(sum.dof[0].weight_square, integral([&](size_t n) { return unit * q(n) * v1(n); }));
  near(sum.dof[0].velocity_instrument, integral([&](size_t n) { return unit * z(n) * v1(n); }));
  const auto x1 = [&](size_t n) { return unit * s[n].code[0][1]; };
  near(sum.dof[0].elastic_discrepancy[0],
       integral([&](size_t n) { return v1(n) * x1(n); }) - 0.5L * (x1(samples - 4) * x1(samples - 4) - x1(3) * x1(3)));
  const auto y = [&](size_t n) {
    return clear[n] == 0 ? 0 : (4 * (x1(n - 1) + x1(n + 1)) - x1(n - 2) - x1(n + 2)) / 6;
  };
  if (layout.weight_count > 2) near(sum.dof[0].displacement_square(), integral([&](size_t n) { return y(n) * x1(n); }));
}

TEST(EnergySums, WithoutAccelerationTheKineticEnergyComesFromTheEndPoints) {
  // A single free mass, v = n codes (2^-10 m/s each): from sample 3 to sample N - 4 the kinetic energy per unit mass is
  // (v1^2 - v0^2)/2 exactly; the rhs with m = 3 known, no springs moving (x = 0) and no force is -3 times that.
  auto c = two_masses(false);
  const auto owner = std::make_unique<EstimatorCore>(*c);
  EstimatorCore& core = *owner;
  core.begin_level();
  constexpr int kSamples = 107;
  for (uint32_t n = 0; n < kSamples; ++n) {
    RawSample s;
    s.sequence = n;
    s.code[0][2] = static_cast<int32_t>(n);
    core.push(s);
  }
  core.end_level();
  const double v0 = 3.0 / 1024.0, v1 = (kSamples - 4) / 1024.0;
  EXPECT_DOUBLE_EQ(to_double(total(core.table(), 0).dof[0].rhs[0]), -3.0 * 0.5 * (v1 * v1 - v0 * v0));
}

TEST(EnergySums, AMissedSampleSplitsTheWindow) {
  const auto c = two_masses(true);
  auto core = std::make_unique<EstimatorCore>(*c);
  core->begin_level();
  for (uint32_t n = 0; n < 1000; ++n)
    if (n < 500 || n >= 510) core->push(sample_at(n));
  core->end_level();
  EXPECT_EQ(core->health().missed_samples, 10u);
  const Batch sum = total(core->table(), 0);
  // 500 samples and 490 samples, each less the margin; the balance holds on both sides of the gap.
  EXPECT_EQ(sum.samples, 990u - 2u * static_cast<unsigned>(core->margin_samples()));
  const double left = 6.0 * to_double(sum.column[0][3]) + 1000.0 / 1024.0 * to_double(sum.column[0][4]);
  EXPECT_NEAR(left, to_double(sum.dof[1].rhs[0]), 1e-10 * std::fabs(left));
}

TEST(EnergySums, ASensorAtFullScaleMarksTheLevel) {
  const auto c = two_masses(true);
  auto core = std::make_unique<EstimatorCore>(*c);
  core->begin_level();
  RawSample s = sample_at(0);
  s.code[1][1] = -8388608;
  core->push(s);
  core->end_level();
  EXPECT_EQ(core->health().saturated_samples, 1u);
  EXPECT_TRUE(core->table().level[0].saturated);
}

namespace {

// One mass to the ground with m a + k u + (c + q t) w = f exactly but for the code's rounding; t from the level's start.
constexpr double kDamping = 4.0, kDrift = 2.0;

std::unique_ptr<CoreConfiguration> drifting_mass() {
  auto c = two_masses(true);
  c->dof_count = c->link_count = 1;
  c->unknown_count = 2;
  c->term_count = 0;
  for (ChannelConfiguration& channel : c->channels[1]) channel.present = false;
  add_term(*c, TermKind::kMass, 0, -1, 3);
  add_term(*c, TermKind::kStiffness, 0, -1, 7);
  add_term(*c, TermKind::kViscous, 0, 0, 0);
  add_term(*c, TermKind::kDriftingViscous, 0, 1, 0);
  copy_measured_signals(*c);
  return c;
}

RawSample drifting_at(uint32_t n) {
  RawSample s = sample_at(n);
  const double damping = kDamping + kDrift * n / 1024.0;
  s.code[0][0] = static_cast<int32_t>(std::lround(3.0 * s.code[0][3] + 7.0 * s.code[0][1] + damping * s.code[0][2]));
  return s;
}

}  // namespace

// Time goes on over missed samples. Counted from kLeadIn - 1 samples behind the start, where the drift has made of c
// c + q (kLeadIn - 1) / 1024. Had time begun again behind the gap, the second half would have had 4 + 2 * 3000 / 1024 = 9.9
// at its start where the first had 4.
TEST(EnergySums, ADriftGoesOnOverAGap) {
  const auto c = drifting_mass();
  auto core = std::make_unique<EstimatorCore>(*c);
  uint32_t n = 77;  // of a rig that has been running
  core->begin_level();
  for (uint32_t at = 0; at < 5000; ++at) {
    RawSample s = drifting_at(at);
    s.sequence = n + at;
    if (at < 2000 || at >= 3000) core->push(s);
  }
  const Estimates& estimates = core->solve();
  EXPECT_NEAR(to_double(estimates.parameters[0].value), kDamping + kDrift * (kLeadIn - 1) / 1024.0, 1e-3);
  EXPECT_NEAR(to_double(estimates.parameters[1].value), kDrift, 1e-3);
  EXPECT_FALSE(core->table().level[0].saturated);
}

// The column of a drift holds 2^20 samples of time. A gap of half of that leaves room, a second one does not: what follows
// is no longer the law, and the level says so.
TEST(EnergySums, ADriftThatHasNoRoomMarksItsLevel) {
  const auto c = drifting_mass();
  auto core = std::make_unique<EstimatorCore>(*c);
  core->begin_level();
  uint32_t at = 0;
  for (int gap = 0; gap < 3; ++gap, at += 1 << 19) {
    for (int i = 0; i < 200; ++i) {
      RawSample s = sample_at(static_cast<uint32_t>(i));
      s.sequence = at++;
      core->push(s);
    }
    EXPECT_EQ(core->table().level[0].saturated, gap == 2) << gap;
  }
  core->begin_level();
  for (uint32_t i = 0; i < 200; ++i) core->push(sample_at(i));
  EXPECT_FALSE(core->table().level[1].saturated);
}
