// Board files in a folder of their own, and a good one.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "hal/linux/board/board_file.hpp"

namespace board_test {

class InItsFolder : public testing::Test {
 protected:
  void SetUp() override {
    char folder[] = "/tmp/board_file_XXXXXX";
    ASSERT_NE(mkdtemp(folder), nullptr);
    folder_ = folder;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  board::BoardFile read(const std::string& text) const {
    std::ofstream(folder_ + "/board.toml") << text;
    return board::read_board_file(folder_ + "/board.toml");
  }
  std::string folder_;
};

inline constexpr char kGood[] = R"(schema = "rig/1"
[node]
id = 3
window_s = 0.5
[can]
interface = "vcan1"
[samples]
source = "can"
wiring = "24"
rate_Hz = 2000
timeout_ms = 2.5
[gpio]
emergency_stop = { line = "stop", active_low = true, bias = "pull_up" }
relay = "gpiochip0:4"
[drive]
output = "can"
limit = 0.5
slew_per_s = 100
[[excitation.level]]
kind = "sine"
amplitude = 0.25
frequency_Hz = 5
ramp_s = 2
measure_s = 30
[[dof]]
mass_kg = 1.0
[[link]]
between = [1, 0]
stiffness_N_m = 100.0
viscous_N_s_m = "estimate"
[[channel]]
name = "force_1_N"
unit_per_code = 0.01
limit_code = 7000000
[[channel]]
name = "displacement_1_m"
unit_per_code = 1e-8
offset_code = -12
)";

class BoardFileTest : public InItsFolder {
 protected:
  // kGood with the first `from` replaced.
  static std::string changed(const std::string& from, const std::string& to) {
    std::string text = kGood;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }
};

}  // namespace board_test
