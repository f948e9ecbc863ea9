// The nine scenarios of the paper, as scenario files. Where the paper is silent (sampling rate, record length,
// settling, the 1-DOF values) the choice is stated in docs/scenarios.md.
#include <string>

#include "host_sim/plant/scenario/scenario.hpp"

namespace host_sim {
namespace {

constexpr char kRig1Dof[] = R"([[dof]]
mass_kg = 2.0
[[link]]
between = [1, 0]
stiffness_N_m = 800.0
viscous_N_s_m = "estimate"
coulomb_N = "estimate"
[truth]
"viscous[1-0]" = 4.0
"coulomb[1-0]" = 2.0
)";

// Fig. 1, Eq. 14: the base motion w(t) acts through k as the force k w(t) on DOF 1
constexpr char kRig2Dof[] = R"([[dof]]
mass_kg = 1.0
[[dof]]
mass_kg = 1.0
[[link]]
between = [1, 0]
stiffness_N_m = 10.0
[[link]]
between = [1, 2]
stiffness_N_m = 20.0
viscous_N_s_m = "estimate"
coulomb_N = "estimate"
[[link]]
between = [2, 0]
stiffness_N_m = 20.0
viscous_N_s_m = "estimate"
coulomb_N = "estimate"
[truth]
"viscous[1-2]" = 6.0
"coulomb[1-2]" = 10.0
"viscous[2-0]" = 6.0
"coulomb[2-0]" = 10.0
)";

// Fig. 4, Eq. 23
constexpr char kRig3Dof[] = R"([[dof]]
mass_kg = 1.5
[[dof]]
mass_kg = 1.3
[[dof]]
mass_kg = 2.0
[[link]]
between = [1, 0]
stiffness_N_m = 1.0e4
viscous_N_s_m = "estimate"
[[link]]
between = [1, 2]
stiffness_N_m = 1.0e4
viscous_N_s_m = "estimate"
[[link]]
between = [2, 3]
stiffness_N_m = 1.0e4
viscous_N_s_m = "estimate"
[[link]]
between = [3, 0]
stiffness_N_m = 1.0e4
viscous_N_s_m = "estimate"
coulomb_N = "estimate"
[truth]
"viscous[1-0]" = 20.0
"viscous[1-2]" = 20.0
"viscous[2-3]" = 20.0
"viscous[3-0]" = 20.0
"coulomb[3-0]" = 1.0
)";

std::string sine(const char* amplitude_N, const char* frequency_Hz, const char* settle_cycles, const char* cycles) {
  return std::string("[[level]]\nkind = \"sine\"\namplitude_N = ") + amplitude_N + "\nfrequency_Hz = " + frequency_Hz +
         "\nsettle_cycles = " + settle_cycles + "\ncycles = " + cycles + "\n";
}

std::string random(const char* rms_N) {
  return std::string("[[level]]\nkind = \"random\"\nrms_N = ") + rms_N +
         "\nband_Hz = [5.0, 50.0]\nsettle_s = 2.0\nduration_s = 20.0\n";
}

std::string decay(const char* displacement_m) {
  return std::string("[[level]]\nkind = \"free_decay\"\ndisplacement_m = ") + displacement_m + "\nduration_s = 1.0\n";
}

constexpr char kClean[] = "[sensors]\nbits = 24\n";
constexpr char kNoisy[] = "[sensors]\nbits = 24\nnoise_percent = 5.0\n";

struct Shipped {
  const char* name;
  const char* description;
  std::string body;
};

const std::vector<Shipped>& shipped() {
  static const std::vector<Shipped> scenarios = {
      {"paper_1dof", "Eq. 4: viscous and Coulomb friction, harmonic force at two levels",
       kRig1Dof + sine("20.0", "4.0", "60", "40") + sine("60.0", "4.0", "60", "40") + kClean},
      {"paper_2dof", "Eq. 14: harmonic base excitation as the force k W0 cos, W0 = 40, 80, 180 m",
       kRig2Dof + sine("400.0", "4.0", "60", "40") + sine("800.0", "4.0", "60", "40") +
           sine("1800.0", "4.0", "60", "40") + kClean},
      {"paper_2dof_noise", "as paper_2dof, 5 % noise on every channel, one cycle of each level",
       kRig2Dof + sine("400.0", "4.0", "60", "1") + sine("800.0", "4.0", "60", "1") + sine("1800.0", "4.0", "60", "1") +
           kNoisy},
      {"paper_3dof_two_frequencies", "Eq. 23: harmonic force of 5 and of 10 Hz",
       kRig3Dof + sine("100.0", "5.0", "30", "100") + sine("100.0", "10.0", "60", "200") + kClean},
      {"paper_3dof_one_frequency", "Eq. 23: harmonic force of 10 Hz at two levels",
       kRig3Dof + sine("100.0", "10.0", "60", "200") + sine("200.0", "10.0", "60", "200") + kClean},
      {"paper_3dof_two_frequencies_noise", "harmonic force of 5 and of 10 Hz, 5 % noise on every channel",
       kRig3Dof + sine("100.0", "5.0", "30", "100") + sine("100.0", "10.0", "60", "200") + kNoisy},
      {"paper_3dof_random", "Eq. 23: random force of 5 to 50 Hz, rms 10 and 40 N",
       kRig3Dof + random("10.0") + random("40.0") + kClean},
      {"paper_3dof_random_noise", "random force of 5 to 50 Hz, rms 10 and 40 N, 5 % noise on every channel",
       kRig3Dof + random("10.0") + random("40.0") + kNoisy},
      {"paper_3dof_free_decay", "Eq. 23 input-free, from two large initial states",
       kRig3Dof + decay("[0.03, 0.01, -0.03]") + decay("[0.02, -0.03, 0.03]") + kClean},
  };
  return scenarios;
}

}  // namespace

std::vector<std::string> shipped_scenario_names() {
  std::vector<std::string> names;
  for (const Shipped& scenario : shipped()) names.emplace_back(scenario.name);
  return names;
}

std::string shipped_scenario_text(const std::string& name) {
  for (const Shipped& scenario : shipped())
    if (name == scenario.name)
      return std::string("schema = \"scenario/1\"\nname = \"") + scenario.name + "\"\ndescription = \"" +
             scenario.description + "\"\nsample_rate_Hz = 1000.0\n" + scenario.body;
  return "";
}

}  // namespace host_sim
