// Every column of the core against the law of its row in double: one test over the whole table, so that a new effect is
// compared as soon as it has a row. Both see the same codes; what may differ is the core's rounding.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "firmware/links/effects.hpp"
#include "host_sim/vocabulary/law.hpp"
#include "tests/vocabulary/typical_shape.hpp"

using namespace firmware;

namespace {

constexpr double kPeriod_s = 0.001;
// The ranges U and W that the core takes for full scale, 0.5 and 8, with a bit to spare.
constexpr double kRangeU = 1.0, kRangeW = 16.0;
constexpr int kBlocks = 40;

// Codes without sign that full scale has.
struct Converter {
  int bits;
  double unit_x() const { return std::ldexp(0.5, -bits); }
  double unit_v() const { return std::ldexp(8.0, -bits); }
};

double to_double(Scaled s) { return std::ldexp(static_cast<double>(s.mantissa), s.exponent); }
Scaled from_double(double x) { return Scaled::from_int(static_cast<int64_t>(std::ldexp(x, 50)), -50); }

// Two tones, so that a link turns at many places; it starts in motion.
int32_t code_u(int n, Converter converter) {
  const double t = n * kPeriod_s;
  return static_cast<int32_t>(
      std::lround((0.2 * std::sin(40.0 * t + 0.3) + 0.1 * std::sin(131.0 * t)) / converter.unit_x()));
}
int32_t code_w(int n, Converter converter) {
  const double t = n * kPeriod_s;
  return static_cast<int32_t>(
      std::lround((8.0 * std::cos(40.0 * t + 0.3) + 13.1 * std::cos(131.0 * t)) / 4.0 / converter.unit_v()));
}

struct CoreColumn {
  std::unique_ptr<CoreConfiguration> configuration = std::make_unique<CoreConfiguration>();
  std::unique_ptr<Frame> frame = std::make_unique<Frame>();
  std::unique_ptr<Effects> effects = std::make_unique<Effects>();
  Scaled unit[kMaxColumns];
  Converter converter;

  CoreColumn(TermKind kind, const vocabulary::Shape& shape, Converter with) : converter(with) {
    CoreConfiguration& c = *configuration;
    c.dof_count = c.link_count = c.term_count = 1;
    c.sample_period_s = from_double(kPeriod_s);
    c.terms[0].kind = kind;
    c.terms[0].shape = from_double(shape.p[0]);
    c.terms[0].second_shape_q26 = static_cast<int32_t>(std::lround(std::ldexp(shape.p[1], 26)));
    for (const int q : {1, 2}) {
      c.channels[0][q].present = true;
      c.channels[0][q].highest_code = (1 << converter.bits) - 1, c.channels[0][q].lowest_code = -(1 << converter.bits);
      c.channels[0][q].unit_per_code = from_double(q == 1 ? converter.unit_x() : converter.unit_v());
    }
    copy_measured_signals(c);
    effects->configure(c, unit);
    effects->restart();
  }
  // Position 0 of a level stands one sample before the first block.
  void fill(int block) {
    for (int i = 0; i < kFrameStride; ++i) {
      const int n = block * kBlockSamples + i - (kLeadIn - 1);
      frame->raw[signal_column(0, Quantity::kDisplacement)][i] = code_u(n, converter);
      frame->raw[signal_column(0, Quantity::kVelocity)][i] = code_w(n, converter);
    }
    effects->fill(*frame, kLeadIn - 1, kLeadIn + kBlockSamples + 2, kBlockSamples);
  }
  double at(int i) const { return frame->raw[kEffectColumn][kLeadIn - 1 + i] * to_double(unit[kEffectColumn]); }
};

void compare(const EffectRow& row, const vocabulary::Shape& shape, Converter converter) {
  CoreColumn core(row.core.term, shape, converter);
  const double step = to_double(core.unit[kEffectColumn]);
  vocabulary::Point before;
  double z[vocabulary::kMemories] = {};
  double largest = 0.0;
  for (int block = 0; block < kBlocks; ++block) {
    core.fill(block);
    for (int i = 0; i < kBlockSamples; ++i) {
      const int n = block * kBlockSamples + i;
      vocabulary::Point at = vocabulary::point(row.kind, code_u(n, converter) * converter.unit_x(),
                                               code_w(n, converter) * converter.unit_v(), n * kPeriod_s, shape);
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

// Of 24 bits with sign, of 16 and of 14: the range is what full scale says, not the width of the core's numbers.
TEST(CoreLaws, EveryColumnIsItsRowsLaw) {
  int compared = 0;
  for (const EffectRow& row : kEffectTable) {
    if (!row.core.estimable || row.role == EffectRole::kCorrection || row.core.term < TermKind::kGravity) continue;
    for (const Converter converter : {Converter{23}, Converter{15}, Converter{13}}) {
      SCOPED_TRACE(std::string(row.word.text) + ", " + std::to_string(converter.bits));
      compare(row, vocabulary_test::typical_shape(row, {0.3, 0.15, 3.0, 1.28, 1000.0, 10.0}), converter);
      bool optional = row.shape.count > 0;
      for (int i = 0; i < row.shape.count; ++i) optional = optional && row.shape.at[i].may_be_left_out;
      if (optional) compare(row, {}, converter);
    }
    ++compared;
  }
  EXPECT_EQ(compared, kTermKinds - static_cast<int>(TermKind::kGravity));
}

// A 12-bit converter has 2^11 codes: its range is that of 2^13, and the gains still hold.
TEST(CoreLaws, OfFewCodesTheRangeIsWiderThanFullScale) {
  CoreColumn core(TermKind::kCubicStiffness, {}, Converter{11});
  // u = 1000 of 2^13 codes of 0.5 / 2^11, a range of 2^(log2(0.5) - 11 + 13 + 1) = 4: u^3 = (1000 / 4096)^3 = 0.014552 m^3
  core.frame->raw[signal_column(0, Quantity::kDisplacement)][kLeadIn] = 1000;
  core.effects->fill(*core.frame, kLeadIn, kLeadIn + 1, 1);
  EXPECT_NEAR(core.frame->raw[kEffectColumn][kLeadIn] * to_double(core.unit[kEffectColumn]), 0.014552, 1e-6);
}
