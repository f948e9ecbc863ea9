// Programmes that must be refused before anything moves.
#include "firmware/excitation/programme.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace {

using firmware::Drive;
using firmware::ExcitationKind;
using firmware::ExcitationProgramme;
using firmware::ProgrammeFault;

ExcitationProgramme good() {
  ExcitationProgramme programme;
  programme.level_count = 2;
  programme.limits.magnitude = Drive::from_raw(1 << 30);
  programme.limits.step_per_sample = Drive::from_raw(1 << 26);
  for (int i = 0; i < 2; ++i) {
    programme.levels[i].amplitude = Drive::from_raw(1 << 29);
    programme.levels[i].phase_step =
        1u << 26;  // 1/64 of the sample rate: steepest step 2 * 2^29 * sin(pi/64) = 5.27e7 < 2^26
    programme.levels[i].ramp_samples = 1000;
    programme.levels[i].measure_samples = 640;
  }
  return programme;
}

struct Case {
  std::string name;
  ProgrammeFault fault;
  std::function<void(ExcitationProgramme&)> breaking;
};

TEST(Programme, GoodOnePasses) {
  uint8_t level = 99;
  EXPECT_EQ(check(good(), level), ProgrammeFault::kNone);
  EXPECT_EQ(level, 99);
}

TEST(Programme, EachFaultIsNamedWithItsLevel) {
  const Case cases[] = {
      {"amplitude zero", ProgrammeFault::kAmplitude, [](auto& p) { p.levels[1].amplitude.raw = 0; }},
      {"amplitude negative", ProgrammeFault::kAmplitude, [](auto& p) { p.levels[1].amplitude.raw = -5; }},
      {"amplitude over limit", ProgrammeFault::kAmplitude, [](auto& p) { p.levels[1].amplitude.raw = (1 << 30) + 1; }},
      {"sine at 0 Hz", ProgrammeFault::kFrequency, [](auto& p) { p.levels[1].phase_step = 0; }},
      {"sine at half the sample rate", ProgrammeFault::kFrequency, [](auto& p) { p.levels[1].phase_step = 1u << 31; }},
      {"empty band", ProgrammeFault::kFrequency,
       [](auto& p) {
         p.levels[1].kind = ExcitationKind::kRandomBand;
         p.levels[1].high_phase_step = p.levels[1].phase_step;
       }},
      {"band over half the sample rate", ProgrammeFault::kFrequency,
       [](auto& p) {
         p.levels[1].kind = ExcitationKind::kRandomBand;
         p.levels[1].high_phase_step = 1u << 31;
       }},
      {"sine too steep", ProgrammeFault::kSlew, [](auto& p) { p.levels[1].phase_step = 1u << 27; }},
      // 5.27e7 and 2^29 / 20 = 2.68e7 are more than 2^26 = 6.71e7; of the amplitude itself the ramp would take but 2^20 / 20
      {"glide down too steep", ProgrammeFault::kSlew,
       [](auto& p) { p.levels[1].amplitude.raw = 1 << 20, p.levels[1].ramp_samples = 20; }},
      {"ramp too steep", ProgrammeFault::kSlew, [](auto& p) { p.levels[1].ramp_samples = 8; }},
      {"no ramp", ProgrammeFault::kLength, [](auto& p) { p.levels[1].ramp_samples = 0; }},
      {"nothing to measure", ProgrammeFault::kLength, [](auto& p) { p.levels[1].measure_samples = 0; }},
      {"settle block too long", ProgrammeFault::kSettle,
       [](auto& p) {
         p.levels[1].settle.block_samples = 65536;
         p.levels[1].settle_limit_samples = 1000000;
       }},
      {"settling without a time limit", ProgrammeFault::kSettle,
       [](auto& p) { p.levels[1].settle.block_samples = 64; }},
      {"one block cannot be compared", ProgrammeFault::kSettle,
       [](auto& p) {
         p.levels[1].settle.block_samples = 64;
         p.levels[1].settle_limit_samples = 1000;
         p.levels[1].settle.blocks = 1;
       }},
  };
  for (const Case& each : cases) {
    ExcitationProgramme programme = good();
    each.breaking(programme);
    uint8_t level = 99;
    EXPECT_EQ(check(programme, level), each.fault) << each.name;
    EXPECT_EQ(level, 1) << each.name;
  }
}

TEST(Programme, TooManyLevels) {
  ExcitationProgramme programme = good();
  programme.level_count = firmware::kMaxLevels + 1;
  uint8_t level = 0;
  EXPECT_EQ(check(programme, level), ProgrammeFault::kTooManyLevels);
}

}  // namespace
