// What a board derives from an accelerometer has codes enough for the motion that its file tells of, and does not reach its limit.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "firmware/estimator_core.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "tests/board/board_file_fixture.hpp"

namespace {

using firmware::EstimateStatus;

constexpr double kMass_kg = 1.0;
// 24 bits for 100 m/s^2 and 100 N.
constexpr double kUnit = 100.0 / 8388608.0;

struct Tone {
  double frequency_Hz, acceleration_m_s2;
};

struct Rig {
  double stiffness_N_m, damper_N_s_m;
};
// 2 % of critical damping.
Rig rig_of(double frequency_Hz) {
  const double w = 2.0 * M_PI * frequency_Hz;
  return {kMass_kg * w * w, 0.04 * kMass_kg * w};
}

std::string board_text(double rate_Hz, const std::string& samples, const std::string& levels) {
  const std::string channel_end = "unit_per_code = " + std::to_string(kUnit * 1e6) + "e-6\n";
  return "schema = \"rig/1\"\n[samples]\nsource = \"can\"\nwiring = \"24\"\nrate_Hz = " + std::to_string(rate_Hz) +
         "\n" + samples + "[gpio]\nemergency_stop = \"stop\"\nrelay = \"relay\"\n[drive]\noutput = \"can\"\n" + levels +
         "[[dof]]\nmass_kg = 1.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = \"estimate\"\n"
         "viscous_N_s_m = \"estimate\"\n"
         "[[channel]]\nname = \"force_1_N\"\n" +
         channel_end + "[[channel]]\nname = \"acceleration_1_m_s2\"\n" + channel_end;
}

std::string sine_level(double frequency_Hz) {
  return "[[excitation.level]]\nkind = \"sine\"\namplitude = 0.1\nfrequency_Hz = " + std::to_string(frequency_Hz) +
         "\nramp_s = 2\nmeasure_s = 10\n";
}

class DerivedCodes : public board_test::InItsFolder {
 protected:
  firmware::CoreConfiguration planned(const std::string& text) const { return read(text).controller.core; }
};

// x = A sin(w t), exactly as the rig moves in the long run; each tone is a level. The accelerometer has noise of some codes.
std::unique_ptr<firmware::EstimatorCore> measured(const firmware::CoreConfiguration& configuration, double rate_Hz,
                                                  const Rig& rig, const std::vector<Tone>& tones,
                                                  double seconds = 10.0) {
  auto core = std::make_unique<firmware::EstimatorCore>(configuration);
  uint32_t state = 1;
  const auto noise = [&] { return static_cast<int32_t>((state = 1664525u * state + 1013904223u) >> 28) - 8; };
  for (const Tone& tone : tones) {
    core->begin_level();
    const double w = 2.0 * M_PI * tone.frequency_Hz, amplitude_m = tone.acceleration_m_s2 / (w * w);
    for (uint32_t n = 0; n < static_cast<uint32_t>(seconds * rate_Hz); ++n) {
      const double x = amplitude_m * std::sin(w * n / rate_Hz), v = amplitude_m * w * std::cos(w * n / rate_Hz);
      firmware::RawSample sample;
      sample.sequence = n;
      sample.code[0][0] = static_cast<int32_t>(
          std::lround((-kMass_kg * w * w * x + rig.damper_N_s_m * v + rig.stiffness_N_m * x) / kUnit));
      sample.code[0][3] = static_cast<int32_t>(std::lround(-w * w * x / kUnit)) + noise();
      core->push(sample);
    }
    core->end_level();
  }
  core->solve();
  return core;
}

void expect_right(const firmware::EstimatorCore& core, const Rig& rig) {
  const auto& stiffness = core.estimates().parameters[0];
  const auto& damper = core.estimates().parameters[1];
  EXPECT_EQ(core.health().saturated_samples, 0u);
  EXPECT_EQ(stiffness.status, EstimateStatus::kValid);
  EXPECT_EQ(damper.status, EstimateStatus::kValid);
  EXPECT_NEAR(rig_file::to_double(stiffness.value) / rig.stiffness_N_m, 1.0, 0.005);
  EXPECT_NEAR(rig_file::to_double(damper.value) / rig.damper_N_s_m, 1.0, 0.02);
}

}  // namespace

// 1 % of the accelerometer's full scale at 200 Hz is 0.6 um: of a full scale for 1 Hz, 2.5 m in 22 bits, less than a code.
TEST_F(DerivedCodes, ADriveTellsHowFastTheMotionIs) {
  const double rate_Hz = 4000.0;
  const Rig rig = rig_of(200.0);
  const auto core = planned(board_text(rate_Hz, "", sine_level(180.3) + sine_level(210.7)));
  expect_right(*measured(core, rate_Hz, rig, {{180.3, 1.0}, {210.7, 1.0}}), rig);
}

TEST_F(DerivedCodes, TwoKilohertz) {
  const double rate_Hz = 20000.0;
  const Rig rig = rig_of(2000.0);
  const auto core = planned(board_text(rate_Hz, "", sine_level(1803.0) + sine_level(2107.0)));
  expect_right(*measured(core, rate_Hz, rig, {{1803.0, 1.0}, {2107.0, 1.0}}, 6.0), rig);
}

// Nearly the whole full scale at half a hertz: 8 m, more than what a full scale for 1 Hz has room for.
TEST_F(DerivedCodes, HalfAHertzHasRoom) {
  const double rate_Hz = 100.0;
  const Rig rig = rig_of(0.6);
  const auto core = planned(board_text(rate_Hz, "", sine_level(0.5) + sine_level(0.7)));
  expect_right(*measured(core, rate_Hz, rig, {{0.5, 80.0}, {0.7, 80.0}}, 200.0), rig);
}

// Near the corner an integral of 24 bits has 35 of them.
TEST_F(DerivedCodes, AFullScaleNearTheCornerIsNotCutOff) {
  const double rate_Hz = 1000.0;
  const Rig rig = rig_of(1.7);
  const auto core = planned(board_text(rate_Hz, "", ""));
  expect_right(*measured(core, rate_Hz, rig, {{1.5, 80.0}, {2.0, 80.0}}, 60.0), rig);
}

// Who listens has to say it; 0.3 % of the full scale at 200 Hz. Where nobody does, what has too few codes is no answer.
TEST_F(DerivedCodes, AListeningBoardIsToldHowSlowTheMotionIs) {
  const double rate_Hz = 20000.0;
  const Rig rig = rig_of(200.0);
  const std::vector<Tone> tones = {{180.3, 0.3}, {210.7, 0.3}};
  expect_right(*measured(planned(board_text(rate_Hz, "slowest_Hz = 100\n", "")), rate_Hz, rig, tones, 6.0), rig);
  const auto untold = measured(planned(board_text(rate_Hz, "", "")), rate_Hz, rig, tones, 6.0);
  const auto& stiffness = untold->estimates().parameters[0];
  EXPECT_GT(std::fabs(rig_file::to_double(stiffness.value) / rig.stiffness_N_m - 1.0), 0.1) << "no test";
  EXPECT_EQ(stiffness.status, EstimateStatus::kBiasSuspect);
}

// The longest period that can be expected is that of the corner and beyond: no motion between the rails fills an integral, a code that
// jumps from rail to rail, each time for as long as that does most, included.
TEST_F(DerivedCodes, NoMotionBetweenTheRailsSaturates) {
  constexpr int kRail = 1 << 20;  // the acceleration itself, behind three sections, has room for 2.5 times that
  for (const double rate_Hz : {100.0, 1000.0})
    for (const char* told : {"", "slowest_Hz = 20\n"}) {
      const std::string rails = "full_scale_code = " + std::to_string(kRail) + "\n";
      const auto core = planned(board_text(rate_Hz, told, "") + rails);
      const double tau = std::ldexp(1.0, core.high_pass_shift);
      for (const double half_period : {0.3, 0.6, 1.0, 1.4, 2.0, 2.8, 4.0, 8.0}) {
        auto run = std::make_unique<firmware::EstimatorCore>(core);
        run->begin_level();
        for (uint32_t n = 0; n < static_cast<uint32_t>(60.0 * tau); ++n) {
          firmware::RawSample sample;
          sample.sequence = n;
          const bool up = static_cast<int>(n / (half_period * tau)) % 2 == 0;
          sample.code[0][3] = (up ? 1 : -1) * (kRail - 1);
          run->push(sample);
        }
        EXPECT_EQ(run->health().saturated_samples, 0u) << rate_Hz << " " << told << half_period;
      }
    }
}
