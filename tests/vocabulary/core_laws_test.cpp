// Every column of the core against the law of its row in double: one test over the whole table, so that a new effect is
// compared as soon as it has a row. Both see the same codes; what may differ is the core's rounding.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "firmware/links/effects.hpp"
#include "host_sim/vocabulary/law.hpp"
#include "tests/vocabulary/typical_shape.hpp"

using namespace firmware;

namespace {

constexpr double kUnitX = 1.0 / (1 << 24), kUnitV = 1.0 / (1 << 20), kPeriod_s = 0.001;
// The ranges U and W that the core takes for 2^23 of such codes with a bit to spare.
constexpr double kRangeU = 1.0, kRangeW = 16.0;
constexpr int kBlocks = 40;

double to_double(Scaled s) { return std::ldexp(static_cast<double>(s.mantissa), s.exponent); }
Scaled from_double(double x) { return Scaled::from_int(static_cast<int64_t>(std::ldexp(x, 50)), -50); }

// Two tones, so that a link turns at many places; it starts in motion.
int32_t code_u(int n) {
  const double t = n * kPeriod_s;
  return static_cast<int32_t>(std::lround((0.2 * std::sin(40.0 * t + 0.3) + 0.1 * std::sin(131.0 * t)) / kUnitX));
}
int32_t code_w(int n) {
  const double t = n * kPeriod_s;
  return static_cast<int32_t>(
      std::lround((8.0 * std::cos(40.0 * t + 0.3) + 13.1 * std::cos(131.0 * t)) / 4.0 / kUnitV));
}

struct CoreColumn {
  std::unique_ptr<CoreConfiguration> configuration = std::make_unique<CoreConfiguration>();
  std::unique_ptr<Frame> frame = std::make_unique<Frame>();
  std::unique_ptr<Effects> effects = std::make_unique<Effects>();
  Scaled unit[kMaxColumns];

  CoreColumn(TermKind kind, const vocabulary::Shape& shape) {
    CoreConfiguration& c = *configuration;
    c.dof_count = c.link_count = c.term_count = 1;
    c.sample_period_s = from_double(kPeriod_s);
    c.terms[0].kind = kind;
    c.terms[0].shape = from_double(shape.p[0]);
    c.terms[0].second_shape_q26 = static_cast<int32_t>(std::lround(std::ldexp(shape.p[1], 26)));
    c.signals[0][1].unit_per_code = from_double(kUnitX);
    c.signals[0][2].unit_per_code = from_double(kUnitV);
    effects->configure(c, unit);
    effects->restart();
  }
  // Position 0 of a level stands one sample before the first block.
  void fill(int block) {
    for (int i = 0; i < kFrameStride; ++i) {
      const int n = block * kBlockSamples + i - (kLeadIn - 1);
      frame->raw[signal_column(0, Quantity::kDisplacement)][i] = code_u(n);
      frame->raw[signal_column(0, Quantity::kVelocity)][i] = code_w(n);
    }
    effects->fill(*frame, kLeadIn - 1, kLeadIn + kBlockSamples + 2, kBlockSamples);
  }
  double at(int i) const { return frame->raw[kEffectColumn][kLeadIn - 1 + i] * to_double(unit[kEffectColumn]); }
};

void compare(const EffectRow& row, const vocabulary::Shape& shape) {
  CoreColumn core(row.core.term, shape);
  const double step = to_double(core.unit[kEffectColumn]);
  vocabulary::Point before;
  double z[vocabulary::kMemories] = {};
  double largest = 0.0;
  for (int block = 0; block < kBlocks; ++block) {
    core.fill(block);
    for (int i = 0; i < kBlockSamples; ++i) {
      const int n = block * kBlockSamples + i;
      vocabulary::Point at = vocabulary::point(row.kind, code_u(n) * kUnitX, code_w(n) * kUnitV, n * kPeriod_s, shape);
      if (n == 0)
        vocabulary::start_memory(row.kind, at, shape, z);
      else
        vocabulary::advance_memory(row.kind, before, at, kPeriod_s, shape, z);
      before = at;
      std::copy(std::begin(z), std::end(z), at.z);
      const vocabulary::Force law = vocabulary::force(row.kind, at, shape);
      // Six steps of the column; elongation and rate rounded to 2^-26 of their ranges; sine and exponential to 3e-8, a
      // memory to that at each step of the way over which it forgets (some tens of samples).
      const double rounding = 2 * std::ldexp(std::abs(law.slope.u) * kRangeU + std::abs(law.slope.w) * kRangeW, -26);
      const double memory = row.nature.memory == Memory::kNone ? 0.0 : 3e-6;
      EXPECT_NEAR(core.at(i), law.value, 6 * step + rounding + (3e-8 + memory) * (1 + std::abs(law.value)))
          << row.word.text << " at sample " << n;
      largest = std::max(largest, std::abs(law.value));
    }
  }
  EXPECT_GT(largest, 100 * step) << row.word.text << " never acted";
}

}  // namespace

TEST(CoreLaws, EveryColumnIsItsRowsLaw) {
  int compared = 0;
  for (const EffectRow& row : kEffectTable) {
    if (!row.core.estimable || row.role == EffectRole::kCorrection || row.core.term < TermKind::kGravity) continue;
    SCOPED_TRACE(row.word.text);
    compare(row, vocabulary_test::typical_shape(row, {0.3, 0.15, 3.0, 1.28, 1000.0, 10.0}));
    bool optional = row.shape.count > 0;
    for (int i = 0; i < row.shape.count; ++i) optional = optional && row.shape.at[i].may_be_left_out;
    if (optional) compare(row, {});
    ++compared;
  }
  EXPECT_EQ(compared, kTermKinds - static_cast<int>(TermKind::kGravity));
}
