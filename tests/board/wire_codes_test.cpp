// Sensor frames of 24 bits do not tell how wide a sensor is: what is lost of its codes, and what is said where too much is.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "firmware/conditioning/conditioning.hpp"
#include "firmware/estimator_core.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "tests/board/board_file_fixture.hpp"

namespace {

using firmware::EstimateStatus;
using firmware::Quantity;

constexpr double kRate_Hz = 1000.0, kMass_kg = 1.0, kUnit_m = 1e-6;

std::string head(const std::string& samples, const std::string& levels) {
  return "schema = \"rig/1\"\n[samples]\nsource = \"can\"\nwiring = \"24\"\nrate_Hz = 1000\n" + samples +
         "[gpio]\nemergency_stop = \"stop\"\nrelay = \"relay\"\n[drive]\noutput = \"can\"\n" + levels +
         "[[dof]]\nmass_kg = \"estimate\"\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = \"estimate\"\n"
         "viscous_N_s_m = \"estimate\"\n";
}

std::string channel(const std::string& name, double unit, const std::string& more) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", unit);
  return "[[channel]]\nname = \"" + name + "\"\nunit_per_code = " + text + "\n" + more;
}

class WireCodes : public board_test::InItsFolder {};

// A rig of 5 % of critical damping at two sines around its resonance; displacement and force in codes.
struct Rig {
  double frequency_Hz;
  double w() const { return 2.0 * M_PI * frequency_Hz; }
  double stiffness() const { return kMass_kg * w() * w(); }
  double damper() const { return 0.1 * kMass_kg * w(); }
  double force_unit() const { return kUnit_m * stiffness(); }
  std::string channels(const std::string& more) const {
    return channel("force_1_N", force_unit(), more) + channel("displacement_1_m", kUnit_m, more);
  }
};

firmware::Estimates estimated(const firmware::CoreConfiguration& configuration, const Rig& rig, double amplitude) {
  auto core = std::make_unique<firmware::EstimatorCore>(configuration);
  for (const double ratio : {0.9013, 1.0537}) {
    core->begin_level();
    const double w = rig.w() * ratio, a = amplitude * kUnit_m;
    for (uint32_t n = 0; n < 60000; ++n) {
      const double t = n / kRate_Hz, x = a * std::sin(w * t), v = a * w * std::cos(w * t);
      firmware::RawSample sample;
      sample.sequence = n;
      sample.code[0][0] = static_cast<int32_t>(
          std::lround((rig.stiffness() * x + rig.damper() * v - kMass_kg * w * w * x) / rig.force_unit()));
      sample.code[0][1] = static_cast<int32_t>(std::lround(x / kUnit_m));
      core->push(sample);
    }
    core->end_level();
  }
  EXPECT_EQ(core->health().saturated_samples, 0u);
  return core->solve();
}

void expect_right(const firmware::Estimates& estimates, const Rig& rig) {
  const double truth[] = {kMass_kg, rig.stiffness(), rig.damper()};
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(estimates.parameters[k].status, EstimateStatus::kValid) << k;
    EXPECT_NEAR(rig_file::to_double(estimates.parameters[k].value) / truth[k], 1.0, 0.005) << k;
  }
}

}  // namespace

// One late channel, and all pass filters: those that are not late come out as they went in.
TEST_F(WireCodes, WhatIsOnlyDelayedKeepsItsCodes) {
  const auto core = read(head("", "") + channel("displacement_1_m", 1.1e-6, "delay_us = 250\n") +
                         channel("velocity_1_m_s", 1.3e-5, "") + channel("acceleration_1_m_s2", 1.7e-4, ""))
                        .controller.core;
  ASSERT_GT(core.signals[0][1].half_length, 0);
  for (const int q : {1, 2, 3})
    EXPECT_EQ(rig_file::to_double(core.signals[0][q].unit_per_code),
              rig_file::to_double(core.channels[0][q].unit_per_code));
  firmware::Conditioning conditioning;
  conditioning.configure(core);
  auto frame = std::make_unique<firmware::Frame>();
  const int delay = core.signals[0][1].half_length;
  for (int n = 0; n < 200; ++n) {
    firmware::RawSample sample;
    sample.code[0][2] = n * n % 37;
    sample.code[0][3] = -n * n % 41;
    if (!conditioning.append(sample, *frame, 0)) continue;
    const int then = n - delay;
    EXPECT_EQ(frame->raw[signal_column(0, Quantity::kVelocity)][0], then * then % 37);
    EXPECT_EQ(frame->raw[signal_column(0, Quantity::kAcceleration)][0], -then * then % 41);
  }
}

// The whole range of a 12-bit converter at 3 Hz: of a full scale of 24 bits its acceleration has one code, and a quarter of the mass was
// left. The file that tells the width has it right; where it does not, the numbers are not believed.
TEST_F(WireCodes, SlopesOfTwelveBits) {
  const Rig rig{3.0};
  expect_right(estimated(read(head("", "") + rig.channels("full_scale_code = 2047\n")).controller.core, rig, 2000.0),
               rig);
  const board::BoardFile untold = read(head("", "") + rig.channels(""));
  const firmware::Estimates estimates = estimated(untold.controller.core, rig, 2000.0);
  EXPECT_GT(std::fabs(rig_file::to_double(estimates.parameters[0].value) - kMass_kg), 0.1) << "no test";
  for (const int k : {0, 1}) EXPECT_NE(estimates.parameters[k].status, EstimateStatus::kValid) << k;
  EXPECT_NE(board::describe(untold).find("displacement_1_m: no full_scale_code"), std::string::npos);
  EXPECT_EQ(board::describe(untold).find("force_1_N: no"), std::string::npos);
}

// A hundredth of 24 bits at 1 Hz of 1 kHz: the acceleration of a full scale at 100 Hz has three codes. A drive tells that it is slow, or the file.
TEST_F(WireCodes, SlopesOfASlowMotion) {
  const Rig rig{1.0};
  const auto level = [](double frequency_Hz) {
    return "[[excitation.level]]\nkind = \"sine\"\namplitude = 0.1\nfrequency_Hz = " + std::to_string(frequency_Hz) +
           "\nmeasure_s = 60\n";
  };
  expect_right(
      estimated(read(head("", level(0.9013) + level(1.0537)) + rig.channels("")).controller.core, rig, 100000.0), rig);
  expect_right(estimated(read(head("fastest_Hz = 5\n", "") + rig.channels("")).controller.core, rig, 100000.0), rig);
}
