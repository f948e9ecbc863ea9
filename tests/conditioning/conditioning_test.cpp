// Derived signals against the analytic motion they stand for.
#include "firmware/conditioning/conditioning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <vector>

#include "hal/rig_file/rig_file_error.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/signal_plan.hpp"

using namespace firmware;

namespace {

constexpr double kPeriod = 0.001;

// One mass on a spring: displacement, velocity and acceleration are all needed.
std::unique_ptr<CoreConfiguration> rig(std::initializer_list<Quantity> measured) {
  auto c = std::make_unique<CoreConfiguration>();
  c->dof_count = c->link_count = 1;
  c->sample_period_s = rig_file::to_scaled(kPeriod);
  c->terms[0].kind = TermKind::kMass;
  c->terms[1].kind = TermKind::kStiffness;
  c->term_count = 2;
  for (Quantity q : measured) {
    c->channels[0][static_cast<int>(q)].present = true;
    c->channels[0][static_cast<int>(q)].unit_per_code = rig_file::to_scaled(std::ldexp(1.0, -22));
  }
  return c;
}

// Amplitude and phase of a signal's column against sin(w t), by projection on the last whole cycles.
struct Response {
  double in_phase, quadrature, offset;
};

Response respond(const CoreConfiguration& c, Quantity signal, Quantity source, double frequency_Hz, int samples) {
  auto conditioning = std::make_unique<Conditioning>();
  auto frame = std::make_unique<Frame>();
  conditioning->configure(c);
  const double w = 2.0 * M_PI * frequency_Hz,
               unit = rig_file::to_double(c.signals[0][static_cast<int>(signal)].unit_per_code);
  Response r{0.0, 0.0, 0.0};
  const int cycle = static_cast<int>(std::lround(1.0 / frequency_Hz / kPeriod)),
            last = samples - samples % cycle - cycle * 4;
  int delay = 0;
  for (const auto& node : c.signals)
    for (const SignalConfiguration& s : node) delay = std::max<int>(delay, s.half_length);
  for (int n = 0; n < samples; ++n) {
    RawSample sample;
    const double delay_s = c.channels[0][static_cast<int>(source)].delay_ns * 1e-9;
    sample.code[0][static_cast<int>(source)] =
        static_cast<int32_t>(std::lround(0.9 * (1 << 22) * std::sin(w * (n * kPeriod - delay_s))));
    const bool usable = conditioning->append(sample, *frame, 0);
    if (!usable || n < last || n >= last + 4 * cycle) continue;
    const double value = frame->raw[signal_column(0, signal)][0] * unit / 0.9;
    const double t = (n - delay) * kPeriod;
    r.in_phase += 2.0 * value * std::sin(w * t) / (4 * cycle);
    r.quadrature += 2.0 * value * std::cos(w * t) / (4 * cycle);
    r.offset += value / (4 * cycle);
  }
  return r;
}

}  // namespace

TEST(Conditioning, AllMeasuredIsACopy) {
  auto c = rig({Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration});
  rig_file::plan_signals(*c);
  Conditioning conditioning;
  conditioning.configure(*c);
  auto frame = std::make_unique<Frame>();
  RawSample sample;
  sample.code[0][1] = -1234567;
  EXPECT_TRUE(conditioning.append(sample, *frame, 5));
  EXPECT_FALSE(conditioning.saturated());
  EXPECT_EQ(frame->raw[signal_column(0, Quantity::kDisplacement)][5], -1234567);
  EXPECT_EQ(conditioning.history_samples(), 0);
}

// Each converter by its own rails: offset binary with 12 bits, unsigned with 24, two's complement with 24. What a code
// beyond 24 bits about the offset would be, is clamped and told.
TEST(Conditioning, ACodeAtEitherRailIsSaturated) {
  const struct {
    int32_t lowest, highest, offset, code;
    bool saturated;
    int32_t signal;
  } cases[] = {
      {0, 4095, 2048, 0, true, -2048},
      {0, 4095, 2048, 1, false, -2047},
      {0, 4095, 2048, 4094, false, 2046},
      {0, 4095, 2048, 4095, true, 2047},
      {0, 16777215, 8388608, 12000000, false, 3611392},  // |code| alone would be over 2^23
      {0, 16777215, 8388608, 16777215, true, 8388607},
      {0, 16777215, 8388608, 0, true, -8388608},
      {-8388608, 8388607, 0, -8388608, true, -8388608},
      {-8388608, 8388607, 0, 8388606, false, 8388606},
      {-8388607, 8388607, 8388608, INT32_MIN, true, -8388608},  // code - offset would overflow
      {-8388607, 8388607, -8388608, INT32_MAX, true, 8388608},
      {INT32_MIN, INT32_MAX, 0, 1 << 28, true, 8388608},  // rails that no converter has: 24 bits remain
  };
  for (const auto& each : cases) {
    auto c = rig({Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration});
    c->channels[0][1].lowest_code = each.lowest;
    c->channels[0][1].highest_code = each.highest;
    c->channels[0][1].offset_code = each.offset;
    copy_measured_signals(*c);
    auto conditioning = std::make_unique<Conditioning>();
    conditioning->configure(*c);
    auto frame = std::make_unique<Frame>();
    RawSample sample;
    sample.code[0][1] = each.code;
    EXPECT_TRUE(conditioning->append(sample, *frame, 0));
    EXPECT_EQ(conditioning->saturated(), each.saturated) << each.code;
    EXPECT_EQ(frame->raw[signal_column(0, Quantity::kDisplacement)][0], each.signal) << each.code;
  }
}

TEST(Conditioning, VelocityAndAccelerationFromDisplacement) {
  // x = sin(w t): v = w cos, a = -w^2 sin, and all three through one low-pass: the ratios are those of the true signals.
  auto c = rig({Quantity::kDisplacement});
  rig_file::plan_signals(*c);
  for (double frequency_Hz : {2.0, 10.0, 50.0}) {
    const double w = 2.0 * M_PI * frequency_Hz;
    rig_file::SignalRanges ranges;
    ranges.largest[0][1] = 1.0;
    ranges.largest[0][2] = w;
    ranges.largest[0][3] = w * w;
    rig_file::plan_signals(*c, ranges);
    const Response x = respond(*c, Quantity::kDisplacement, Quantity::kDisplacement, frequency_Hz, 4000);
    const Response v = respond(*c, Quantity::kVelocity, Quantity::kDisplacement, frequency_Hz, 4000);
    const Response a = respond(*c, Quantity::kAcceleration, Quantity::kDisplacement, frequency_Hz, 4000);
    EXPECT_NEAR(x.in_phase, 1.0, 0.03);  // the low-pass's own gain
    EXPECT_NEAR(v.quadrature / x.in_phase, w, 2e-6 * w);
    EXPECT_NEAR(a.in_phase / x.in_phase, -w * w, 1e-5 * w * w);
    EXPECT_NEAR(v.in_phase / w, 0.0, 1e-6);
  }
}

TEST(Conditioning, VelocityAndDisplacementFromAcceleration) {
  // a = sin(w t): v = -cos / w, x = -sin / w^2, all three through the same three sections (1 - z^-1) / (1 - p z^-1) with
  // p = 1 - 2^-7 (corner 1.24 Hz), each of gain 2 sin(w h / 2) / sqrt(1 + p^2 - 2 p cos(w h)).
  auto c = rig({Quantity::kAcceleration});
  rig_file::plan_signals(*c);
  for (double frequency_Hz : {5.0, 20.0, 50.0}) {
    const double w = 2.0 * M_PI * frequency_Hz;
    const auto complex = [](Response r) { return std::complex<double>(r.in_phase, r.quadrature); };
    const auto a = complex(respond(*c, Quantity::kAcceleration, Quantity::kAcceleration, frequency_Hz, 20000));
    const auto v = complex(respond(*c, Quantity::kVelocity, Quantity::kAcceleration, frequency_Hz, 20000));
    const auto x = complex(respond(*c, Quantity::kDisplacement, Quantity::kAcceleration, frequency_Hz, 20000));
    const double p = 1.0 - 1.0 / 128.0, turn = w * kPeriod;
    const double gain = 2.0 * std::sin(turn / 2.0) / std::sqrt(1.0 + p * p - 2.0 * p * std::cos(turn));
    EXPECT_NEAR(std::abs(a), std::pow(gain, 3), 1e-3);
    EXPECT_NEAR(std::abs(v / a - std::complex<double>(0.0, -1.0 / w)) * w, 0.0, 2e-4);
    EXPECT_NEAR(std::abs(x / a + 1.0 / (w * w)) * w * w, 0.0, 1e-3);
  }
}

// v = cos(w t) from the first sample on, at 8 Hz. The pole is 1 - 2^-10 at the end (0.2 Hz), 2^-9 for the time constant before: where the first
// samples are used, v[0] is forgotten, and the last step of the pole leaves the displacement's 1 / w times 1 / (2^10 samples), 2 % of the
// velocity; the steps before were twice as large each and have decayed by 1 / e twice, once for each section. With one pole from the start
// v[0] is still there, (1 - t / T) exp(-t / T) of it: 13 % at two time constants T.
TEST(Conditioning, AStartInMidMotionIsForgottenWhereSamplesAreUsed) {
  auto c = rig({Quantity::kVelocity});
  rig_file::plan_signals(*c);
  Conditioning conditioning;
  conditioning.configure(*c);
  auto frame = std::make_unique<Frame>();
  const double w = 2.0 * M_PI * 8.0;
  const double x_unit = rig_file::to_double(c->signals[0][1].unit_per_code),
               v_unit = rig_file::to_double(c->signals[0][2].unit_per_code);
  double x[2] = {}, v[2] = {}, worst = 0.0;
  int used = 0;
  for (int n = 0; n < 6000; ++n) {
    RawSample sample;
    sample.code[0][2] = static_cast<int32_t>(std::lround(0.9 * (1 << 22) * std::cos(w * n * kPeriod)));
    if (!conditioning.append(sample, *frame, 0)) continue;
    const double x_now = frame->raw[signal_column(0, Quantity::kDisplacement)][0] * x_unit,
                 v_now = frame->raw[signal_column(0, Quantity::kVelocity)][0] * v_unit;
    // Central difference of a sine: its slope times sin(w h) / (w h).
    const double slope = (x_now - x[0]) / (2.0 * kPeriod) * (w * kPeriod) / std::sin(w * kPeriod);
    if (++used > 2) worst = std::max(worst, std::fabs(slope - v[1]) / 0.9);
    x[0] = x[1], x[1] = x_now, v[0] = v[1], v[1] = v_now;
  }
  EXPECT_GT(used, 4000);  // one time constant is waited for
  EXPECT_LT(worst, 0.05);
}

TEST(Conditioning, AnOffsetDoesNotDrift) {
  auto c = rig({Quantity::kAcceleration});
  c->channels[0][3].offset_code = 0;
  rig_file::plan_signals(*c);
  Conditioning conditioning;
  conditioning.configure(*c);
  auto frame = std::make_unique<Frame>();
  int32_t largest = 0;
  for (int n = 0; n < 20000; ++n) {
    RawSample sample;
    sample.code[0][3] = 100000;  // nothing but an offset
    if (conditioning.append(sample, *frame, 0))
      largest = std::max(largest, std::abs(frame->raw[signal_column(0, Quantity::kDisplacement)][0]));
  }
  EXPECT_LE(largest, 1);
}

// The pole 1 - 2^-n stays for 2^n samples: the first, 1/2, for 2, the next, 3/4, for 4, until 6 have come. The last one stays
// for ever, also behind 2^32 samples, which are 60 hours at 20 kHz.
TEST(Conditioning, TheLastPoleStays) {
  EXPECT_EQ(starting_leak(0, 12, 1), 1);
  EXPECT_EQ(starting_leak(1, 12, 1), 1);
  EXPECT_EQ(starting_leak(2, 12, 1), 2);
  EXPECT_EQ(starting_leak(5, 12, 1), 2);
  EXPECT_EQ(starting_leak(6, 12, 1), 3);
  EXPECT_EQ(starting_leak(23, 12, 4), 2);
  EXPECT_EQ(starting_leak(24, 12, 4), 3);
  for (const uint32_t samples : {8190u, INT32_MAX + 0u, UINT32_MAX - 1, UINT32_MAX})
    EXPECT_EQ(starting_leak(samples, 12, 1), 12) << samples;
}

TEST(Conditioning, ALateChannelIsMovedBack) {
  // Displacement 250 us late: after the plan has moved it back by a quarter sample the projection has no quadrature part.
  auto c = rig({Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration});
  c->channels[0][1].delay_ns = 250000;
  rig_file::plan_signals(*c);
  // A microsecond at 5 Hz is 3e-5 of a radian: the tolerance is a thirtieth of that, and the codes' rounding.
  for (double frequency_Hz : {5.0, 50.0, 125.0}) {
    const Response x = respond(*c, Quantity::kDisplacement, Quantity::kDisplacement, frequency_Hz, 4000);
    const Response v = respond(*c, Quantity::kVelocity, Quantity::kVelocity, frequency_Hz, 4000);
    EXPECT_NEAR(x.in_phase, 1.0, 2e-6);
    EXPECT_NEAR(x.quadrature, 0.0, 1e-6);
    EXPECT_NEAR(v.quadrature, 0.0, 1e-6);  // the others have the same delay and no shift
  }
}

TEST(Conditioning, DelayAndDifferencesTogether) {
  // Displacement alone and late: the derived velocity and acceleration are moved back with it.
  auto c = rig({Quantity::kDisplacement});
  c->channels[0][1].delay_ns = -730000;
  rig_file::plan_signals(*c);
  const double w = 2.0 * M_PI * 20.0;
  rig_file::SignalRanges ranges;
  ranges.largest[0][1] = 1.0;
  ranges.largest[0][2] = w;
  ranges.largest[0][3] = w * w;
  rig_file::plan_signals(*c, ranges);
  const Response v = respond(*c, Quantity::kVelocity, Quantity::kDisplacement, 20.0, 4000);
  EXPECT_NEAR(v.in_phase / w, 0.0, 3e-6);
  EXPECT_NEAR(v.quadrature / w, 1.0, 0.03);
}

TEST(Conditioning, ADofWithoutMotionIsRefused) {
  auto c = rig({Quantity::kForce});
  EXPECT_THROW(rig_file::plan_signals(*c), rig_file::RigFileError);
}

TEST(Conditioning, RangesOfARecordedMotion) {
  // x = 0.5 sin(2 pi 10 t): v reaches 31.4, a 1974.
  auto c = rig({Quantity::kDisplacement});
  rig_file::plan_signals(*c);
  std::vector<RawSample> record(3000);
  for (size_t n = 0; n < record.size(); ++n)
    record[n].code[0][1] = static_cast<int32_t>(
        std::lround(0.5 * (1 << 22) * std::sin(2.0 * M_PI * 10.0 * kPeriod * static_cast<double>(n))));
  const rig_file::SignalRanges ranges = rig_file::measure_ranges(*c, {record});
  EXPECT_NEAR(ranges.largest[0][2], 0.5 * 62.83, 0.5);
  EXPECT_NEAR(ranges.largest[0][3], 0.5 * 3948, 30.0);
}

// Displacement alone, without friction and with it, so that the velocity comes a second time, early, for friction's sign: every
// column against its filter written out, whatever passes and outputs they share. Codes by a linear congruence: no motion, every
// bit matters.
class SharedPasses : public ::testing::TestWithParam<bool> {};
TEST_P(SharedPasses, GiveWhatEachFilterGives) {
  auto c = rig({Quantity::kDisplacement});
  if (GetParam()) {
    c->terms[2].kind = TermKind::kCoulomb;
    c->term_count = 3;
  }
  rig_file::plan_signals(*c);
  ASSERT_EQ(c->sign_half_length > 0, GetParam());
  auto conditioning = std::make_unique<Conditioning>();
  conditioning->configure(*c);
  auto frame = std::make_unique<Frame>();
  int reach = c->sign_half_length;
  for (const SignalConfiguration& s : c->signals[0]) reach = std::max(reach, c->sign_half_length + s.half_length);
  std::vector<int32_t> code;
  uint32_t state = 1;
  const auto expected = [&](Quantity quantity, size_t at) {
    const SignalConfiguration& s = c->signals[0][static_cast<int>(quantity)];
    int64_t sum = 0;
    for (int k = -s.half_length; k <= s.half_length; ++k)
      sum += int64_t{s.tap[s.half_length + k].raw} * code[static_cast<size_t>(static_cast<int>(at) + k)];
    return static_cast<int32_t>((sum + (int64_t{1} << (s.shift - 1))) >> s.shift);
  };
  int compared = 0;
  for (size_t n = 0; n < 300; ++n) {
    state = 1664525u * state + 1013904223u;
    RawSample sample;
    code.push_back(static_cast<int32_t>(state >> 13) - (1 << 18));
    sample.code[0][static_cast<int>(Quantity::kDisplacement)] = code.back();
    if (!conditioning->append(sample, *frame, 3)) continue;
    const size_t at = n - static_cast<size_t>(reach);
    for (Quantity q : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
      EXPECT_EQ(frame->raw[signal_column(0, q)][3], expected(q, at)) << n << " " << static_cast<int>(q);
    if (GetParam()) {
      EXPECT_EQ(frame->raw[kSignVelocityColumn][3], expected(Quantity::kVelocity, at + c->sign_half_length)) << n;
    }
    ++compared;
  }
  EXPECT_EQ(compared, 300 - 2 * reach);
}
INSTANTIATE_TEST_SUITE_P(WithoutAndWithFriction, SharedPasses, ::testing::Bool());

// An acceleration in a sixteenth of its unit cannot hold jumps from rail to rail, with friction or without: the samples at whose
// place it has reached its limit are saturated, not those at which it was made, early for friction's sign.
TEST_P(SharedPasses, AnAccelerationAtItsLimitIsSaturated) {
  auto c = rig({Quantity::kDisplacement});
  if (GetParam()) {
    c->terms[2].kind = TermKind::kCoulomb;
    c->term_count = 3;
  }
  rig_file::plan_signals(*c);
  SignalConfiguration& acceleration = c->signals[0][static_cast<int>(Quantity::kAcceleration)];
  acceleration.shift = static_cast<uint8_t>(acceleration.shift - 4);
  auto conditioning = std::make_unique<Conditioning>();
  conditioning->configure(*c);
  auto frame = std::make_unique<Frame>();
  int32_t state = 0, saturated = 0;
  for (int n = 0; n < 400; ++n) {
    RawSample sample;
    if (n >= 200) state = n / 10 % 2 == 0 ? 8000000 : -8000000;
    sample.code[0][static_cast<int>(Quantity::kDisplacement)] = state;
    if (!conditioning->append(sample, *frame, 3)) continue;
    bool at_limit = false;
    for (Quantity q : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
      at_limit = at_limit || std::abs(frame->raw[signal_column(0, q)][3]) == 1 << 23;
    EXPECT_EQ(conditioning->saturated(), at_limit) << n;
    saturated += at_limit ? 1 : 0;
  }
  EXPECT_GT(saturated, 0);
}

// An accelerometer alone, 2 Hz: w = 12.57 rad/s, and the sections of the sign's velocity have tau = 1.024 s, eight times those of the other
// signals (1 Hz: 2^7 samples). Two of them lead by 2 atan(1 / w tau) = 0.155 rad. The leaking sum, of tau / 4, brings back
// arg(1 + 2 / (j w tau + 4)) = atan(-0.1416 / 1.0440) = -0.135 rad.
TEST(Conditioning, TheVelocityOfFrictionsSignIsNotAhead) {
  auto c = rig({Quantity::kAcceleration});
  c->terms[2].kind = TermKind::kCoulomb;
  c->term_count = 3;
  rig_file::plan_signals(*c);
  ASSERT_EQ(c->high_pass_shift, 7);
  auto conditioning = std::make_unique<Conditioning>();
  conditioning->configure(*c);
  auto frame = std::make_unique<Frame>();
  int reach = 0;
  for (const SignalConfiguration& s : c->signals[0]) reach = std::max<int>(reach, s.half_length);
  const double omega = 2 * M_PI * 2;
  double in_phase = 0, ahead = 0;
  for (int n = 0; n < 20000; ++n) {
    RawSample sample;  // v = 0.01 sin(w t) m/s
    sample.code[0][static_cast<int>(Quantity::kAcceleration)] =
        static_cast<int32_t>(std::lround(std::ldexp(0.01 * omega * std::cos(omega * n * kPeriod), 22)));
    if (!conditioning->append(sample, *frame, 3) || n < 15000) continue;  // then whole cycles of 500 samples
    const double phase = omega * (n - reach) * kPeriod, v = frame->raw[kSignVelocityColumn][3];
    in_phase += v * std::sin(phase), ahead += v * std::cos(phase);
  }
  EXPECT_NEAR(std::atan2(ahead, in_phase), 0.020, 0.005);
}
