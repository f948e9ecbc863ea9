// The course of a programme, sample by sample.
#include "firmware/excitation/excitation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

namespace {

using firmware::Drive;
using firmware::Excitation;
using firmware::ExcitationEvent;
using firmware::ExcitationKind;
using firmware::ExcitationProgramme;
using firmware::ExcitationState;

constexpr int32_t kHalf = 1 << 30;

ExcitationProgramme sine_programme(int levels) {
  ExcitationProgramme programme;
  programme.level_count = static_cast<uint8_t>(levels);
  for (int i = 0; i < levels; ++i) {
    auto& level = programme.levels[i];
    level.amplitude = Drive::from_raw(kHalf >> (levels - 1 - i));
    level.phase_step = 1u << 28;  // 16 samples a cycle
    level.ramp_samples = 40;
    level.settle.block_samples = 16;
    level.settle.blocks = 2;
    level.settle_limit_samples = 400;
    level.measure_samples = 160;
  }
  return programme;
}

struct Log {
  std::vector<ExcitationEvent> events;
  std::vector<int> event_samples;
  std::vector<int32_t> drive;
  int count(ExcitationEvent event) const {
    int found = 0;
    for (ExcitationEvent each : events) found += each == event ? 1 : 0;
    return found;
  }
};

// A rig without memory: the response is the drive of the sample before, in codes.
Log run(const ExcitationProgramme& programme, int samples, int32_t gain = 1) {
  Excitation excitation;
  excitation.configure(programme, 1);
  excitation.start();
  Log log;
  for (int i = 0; i < samples; ++i) {
    const int32_t response = gain * (excitation.drive().raw >> 8);
    const ExcitationEvent event = excitation.step(&response);
    if (event != ExcitationEvent::kNone) {
      log.events.push_back(event);
      log.event_samples.push_back(i);
    }
    log.drive.push_back(excitation.drive().raw);
    if (excitation.state() == ExcitationState::kDone) break;
  }
  return log;
}

TEST(Excitation, TwoLevelsMeasureTheAskedNumberOfSamplesAndEndAtZero) {
  const Log log = run(sine_programme(2), 5000);
  using E = ExcitationEvent;
  EXPECT_EQ(log.events,
            (std::vector<E>{E::kMeasureBegins, E::kMeasureEnds, E::kMeasureBegins, E::kMeasureEnds, E::kFinished}));
  EXPECT_EQ(log.event_samples[1] - log.event_samples[0], 160);
  EXPECT_EQ(log.event_samples[3] - log.event_samples[2], 160);
  EXPECT_EQ(log.drive.back(), 0);
}

TEST(Excitation, DriveNeverExceedsAmplitudeLimitAndSlew) {
  ExcitationProgramme programme = sine_programme(2);
  programme.limits.magnitude = Drive::from_raw(kHalf);
  // Steepest step: 2 * 2^30 * sin(pi/16) = 4.19e8, plus the ramp's 2^30 / 40 = 2.7e7.
  programme.limits.step_per_sample = Drive::from_raw(447000000);
  uint8_t level = 0;
  ASSERT_EQ(check(programme, level), firmware::ProgrammeFault::kNone);
  const Log log = run(programme, 5000);
  int32_t before = 0;
  for (int32_t drive : log.drive) {
    EXPECT_LE(std::abs(drive), kHalf);
    EXPECT_LE(std::abs(static_cast<int64_t>(drive) - before), 447000000);
    before = drive;
  }
  EXPECT_EQ(log.count(ExcitationEvent::kFinished), 1);
}

TEST(Excitation, MeasuredDriveIsTheSineOfTheStatedAmplitude) {
  const Log log = run(sine_programme(1), 5000);
  // Drive commands during the measurement: fit A sin + B cos over 160 samples = 10 cycles, A^2 + B^2 = amplitude^2.
  double a = 0.0, b = 0.0;
  const int begin = log.event_samples[0];
  for (int i = 0; i < 160; ++i) {
    const double phase = 2.0 * M_PI * i / 16.0;
    a += log.drive[static_cast<size_t>(begin + i)] * std::sin(phase) / 80.0;
    b += log.drive[static_cast<size_t>(begin + i)] * std::cos(phase) / 80.0;
  }
  EXPECT_NEAR(std::hypot(a, b) / kHalf, 1.0, 1e-7);
}

TEST(Excitation, SameFrequencyGlidesWithoutComingDown) {
  const Log log = run(sine_programme(2), 5000);
  // Between the levels the peak over each cycle never falls below the first amplitude.
  for (int i = log.event_samples[1]; i + 16 < log.event_samples[2]; ++i) {
    int32_t peak = 0;
    for (int k = 0; k < 16; ++k) peak = std::max(peak, std::abs(log.drive[static_cast<size_t>(i + k)]));
    EXPECT_GE(peak, static_cast<int32_t>(0.98 * (kHalf / 2))) << i;
  }
}

// From 2^30 down to 2^20, a thousandth: at the rate of the smaller amplitude it would take 40 * 1024 samples.
ExcitationProgramme glide_down() {
  ExcitationProgramme programme = sine_programme(2);
  programme.levels[0].amplitude = Drive::from_raw(kHalf), programme.levels[1].amplitude = Drive::from_raw(kHalf >> 10);
  return programme;
}

TEST(Excitation, AGlideDownTakesTheRampOfItsLevel) {
  const Log log = run(glide_down(), 5000);
  ASSERT_EQ(log.count(ExcitationEvent::kMeasureEnds), 2);
  // 40 samples of ramp, then 32 to 400 until the response has settled
  EXPECT_LE(log.event_samples[2] - log.event_samples[1], 40 + 400 + 2);
}

TEST(Excitation, StopInAGlideIsAtZeroWithinTheRamp) {
  for (int into_glide = 0; into_glide <= 45; ++into_glide) {
    Excitation excitation;
    const ExcitationProgramme programme = glide_down();
    excitation.configure(programme, 1);
    excitation.start();
    const int32_t response = 0;
    while (excitation.step(&response) != ExcitationEvent::kMeasureEnds) {
    }
    for (int i = 0; i < into_glide; ++i) excitation.step(&response);
    excitation.stop();
    int samples = 0;
    while (excitation.state() != ExcitationState::kDone && samples < 1000) excitation.step(&response), ++samples;
    EXPECT_LE(samples, 41) << into_glide << " samples into the glide";
    EXPECT_EQ(excitation.drive().raw, 0);
  }
}

// A thousandth of full scale, 2147484, in 1,200,000 samples: 1.79 a sample. At 1 it takes 2147484 samples, at 2 it is there after
// 1073742, and as soon back at zero.
TEST(Excitation, ALongRampOfASmallAmplitudeKeepsItsTime) {
  ExcitationProgramme programme = sine_programme(1);
  programme.levels[0].amplitude = Drive::from_raw(2147484);
  programme.levels[0].ramp_samples = 1200000;
  Excitation excitation;
  excitation.configure(programme, 1);
  excitation.start();
  const int32_t response = 0;
  int samples = 0;
  while (excitation.state() == ExcitationState::kRamping) excitation.step(&response), ++samples;
  EXPECT_EQ(samples, 1073742);
  excitation.stop();
  samples = 0;
  while (excitation.state() != ExcitationState::kDone) excitation.step(&response), ++samples;
  EXPECT_EQ(samples, 1073742);
}

TEST(Excitation, OtherFrequencyComesDownToZeroFirst) {
  ExcitationProgramme programme = sine_programme(2);
  programme.levels[1].phase_step = 1u << 27;
  const Log log = run(programme, 5000);
  int zeros_in_row = 0, longest = 0;
  for (int i = log.event_samples[1]; i < log.event_samples[2]; ++i) {
    zeros_in_row = log.drive[static_cast<size_t>(i)] == 0 ? zeros_in_row + 1 : 0;
    longest = std::max(longest, zeros_in_row);
  }
  EXPECT_GE(longest, 1);
  EXPECT_EQ(log.count(ExcitationEvent::kMeasureEnds), 2);
}

TEST(Excitation, ResponseThatNeverSettlesIsMeasuredAsUnsettledOrLeftOut) {
  for (bool skip : {false, true}) {
    ExcitationProgramme programme = sine_programme(1);
    programme.levels[0].skip_when_unsettled = skip;
    Excitation excitation;
    excitation.configure(programme, 1);
    excitation.start();
    int began = -1, skipped = -1;
    bool unsettled = false;
    for (int i = 0; i < 3000; ++i) {
      const auto response = static_cast<int32_t>((i % 16 < 8 ? 1000 : -1000) * (1 + i / 16));  // grows every cycle
      const ExcitationEvent event = excitation.step(&response);
      if (event == ExcitationEvent::kMeasureBegins) {
        began = i;
        unsettled = excitation.unsettled();
      }
      if (event == ExcitationEvent::kLevelSkipped) skipped = i;
    }
    // 2^30 / 40 rounds down, so the ramp takes 41 samples (0 to 40); then 400 samples of waiting: 41 to 440.
    EXPECT_EQ(began, skip ? -1 : 440);
    EXPECT_EQ(skipped, skip ? 440 : -1);
    EXPECT_EQ(unsettled, !skip);
    EXPECT_EQ(excitation.state(), ExcitationState::kDone);
  }
}

TEST(Excitation, FreeDecayHoldsThenReleasesAtOnce) {
  ExcitationProgramme programme = sine_programme(1);
  auto& level = programme.levels[0];
  level.kind = ExcitationKind::kFreeDecay;
  level.phase_step = 0;
  level.settle.floor_code = 2;
  const Log log = run(programme, 2000);
  const auto begin = static_cast<size_t>(log.event_samples[0]);
  EXPECT_NEAR(log.drive[begin - 1], kHalf, 1);
  for (size_t i = begin; i < log.drive.size(); ++i) EXPECT_EQ(log.drive[i], 0);
  EXPECT_EQ(log.event_samples[1] - log.event_samples[0], 160);
}

TEST(Excitation, RandomPeaksAreCutAtTheLimitAndCounted) {
  ExcitationProgramme programme = sine_programme(1);
  auto& level = programme.levels[0];
  level.kind = ExcitationKind::kRandomBand;
  level.high_phase_step = 1u << 29;
  level.amplitude = Drive::from_raw(kHalf / 2);
  level.settle.block_samples = 0;
  level.measure_samples = 5000;
  programme.limits.magnitude = Drive::from_raw(kHalf);  // 2 rms: about 4.6 % of a Gaussian lies beyond
  Excitation excitation;
  excitation.configure(programme, 1);
  excitation.start();
  const int32_t response = 0;
  double square_sum = 0.0;
  int over = 0;
  for (int i = 0; i < 5000; ++i) {
    excitation.step(&response);
    EXPECT_LE(std::abs(excitation.drive().raw), kHalf);
    over += std::abs(excitation.drive().raw) == kHalf ? 1 : 0;
    square_sum += std::pow(excitation.drive().raw / static_cast<double>(kHalf / 2), 2);
  }
  EXPECT_NEAR(over / 5000.0, 0.046, 0.02);
  EXPECT_NEAR(std::sqrt(square_sum / 5000.0), 0.96, 0.05);  // clipping at 2 rms takes about 4 % of the rms
}

TEST(Excitation, AbortIsZeroAtOnceStopRampsDown) {
  const ExcitationProgramme programme = sine_programme(2);
  for (bool abort : {true, false}) {
    Excitation excitation;
    excitation.configure(programme, 1);
    excitation.start();
    const int32_t response = 0;
    for (int i = 0; i < 30; ++i) excitation.step(&response);
    if (abort) {
      excitation.abort();
      EXPECT_EQ(excitation.drive().raw, 0);
      EXPECT_EQ(excitation.state(), ExcitationState::kIdle);
      continue;
    }
    excitation.stop();
    int finished = -1;
    for (int i = 0; i < 100 && finished < 0; ++i) {
      if (excitation.step(&response) == ExcitationEvent::kFinished) finished = i;
    }
    // Envelope after 30 steps of amplitude / 40 comes down in 30 steps: the first one is step 0.
    EXPECT_EQ(finished, 29);
    EXPECT_EQ(excitation.drive().raw, 0);
  }
}

TEST(Excitation, EmptyProgrammeNeverDrives) {
  const ExcitationProgramme programme;
  Excitation excitation;
  excitation.configure(programme, 1);
  excitation.start();
  const int32_t response = 0;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(excitation.step(&response), ExcitationEvent::kNone);
  EXPECT_EQ(excitation.state(), ExcitationState::kIdle);
  EXPECT_EQ(excitation.drive().raw, 0);
}

}  // namespace
