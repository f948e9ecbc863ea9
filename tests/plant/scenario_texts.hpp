// A small scenario file that is right, for tests that spoil one thing.
#pragma once
#include <string>

namespace plant_test {

inline std::string small_scenario() {
  return R"(schema = "scenario/1"
name = "small"
sample_rate_Hz = 1000.0
[[dof]]
mass_kg = 2.0
[[link]]
between = [1, 0]
stiffness_N_m = 800.0
viscous_N_s_m = "estimate"
[truth]
"viscous[1-0]" = 4.0
[[level]]
kind = "sine"
amplitude_N = 20.0
frequency_Hz = 4.0
settle_s = 1.0
duration_s = 2.0
[sensors]
bits = 24
)";
}

// The text with its first `from` replaced.
inline std::string spoiled(const std::string& from, const std::string& to) {
  std::string text = small_scenario();
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace plant_test
