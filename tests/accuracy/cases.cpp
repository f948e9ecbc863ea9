#include "tests/accuracy/cases.hpp"

#include <cmath>
#include <limits>

namespace accuracy {
namespace {

// A forked rig: DOF 1 carries DOFs 2 and 3, DOF 4 hangs on DOF 2; friction between DOFs 1 and 3.
constexpr char kFork[] = R"(schema = "scenario/1"
name = "fork_4dof_random"
sample_rate_Hz = 1000.0
[[dof]]
mass_kg = 2.0
[[dof]]
mass_kg = 0.8
[[dof]]
mass_kg = 1.2
[[dof]]
mass_kg = 0.5
[[link]]
between = [1, 0]
stiffness_N_m = 8.0e3
viscous_N_s_m = "estimate"
[[link]]
between = [1, 2]
stiffness_N_m = 6.0e3
viscous_N_s_m = "estimate"
[[link]]
between = [1, 3]
stiffness_N_m = 9.0e3
viscous_N_s_m = "estimate"
coulomb_N = "estimate"
[[link]]
between = [2, 4]
stiffness_N_m = 3.0e3
viscous_N_s_m = "estimate"
[truth]
"viscous[1-0]" = 15.0
"viscous[1-2]" = 8.0
"viscous[1-3]" = 12.0
"coulomb[1-3]" = 0.6
"viscous[2-4]" = 5.0
[[level]]
kind = "random"
rms_N = 30.0
band_Hz = [4.0, 40.0]
settle_s = 2.0
duration_s = 20.0
[[level]]
kind = "random"
rms_N = 120.0
band_Hz = [4.0, 40.0]
settle_s = 2.0
duration_s = 20.0
[sensors]
bits = 24
noise_percent = 5.0
)";

// A heavy two-mass frame with friction at both masses, harmonic force at two frequencies and two levels.
constexpr char kFrame[] = R"(schema = "scenario/1"
name = "frame_2dof_sine"
sample_rate_Hz = 1000.0
[[dof]]
mass_kg = 40.0
[[dof]]
mass_kg = 12.0
[[link]]
between = [1, 0]
stiffness_N_m = 3.0e5
viscous_N_s_m = "estimate"
coulomb_N = "estimate"
[[link]]
between = [1, 2]
stiffness_N_m = 1.2e5
viscous_N_s_m = "estimate"
[[link]]
between = [2, 0]
stiffness_N_m = 2.0e4
viscous_N_s_m = "estimate"
coulomb_N = "estimate"
[truth]
"viscous[1-0]" = 400.0
"coulomb[1-0]" = 30.0
"viscous[1-2]" = 150.0
"viscous[2-0]" = 60.0
"coulomb[2-0]" = 8.0
[[level]]
kind = "sine"
amplitude_N = 600.0
frequency_Hz = 10.0
settle_cycles = 40
cycles = 200
[[level]]
kind = "sine"
amplitude_N = 600.0
frequency_Hz = 12.5
settle_cycles = 50
cycles = 250
[[level]]
kind = "sine"
amplitude_N = 1800.0
frequency_Hz = 12.5
settle_cycles = 50
cycles = 250
[sensors]
bits = 24
noise_percent = 5.0
)";

Case shipped(const std::string& name, const std::string& title, std::vector<double> paper = {}) {
  return {name, title, with_noise(name, 5.0), std::move(paper)};
}

}  // namespace

host_sim::Scenario with_noise(const std::string& shipped_name, double noise_percent) {
  host_sim::Scenario scenario = host_sim::load_scenario(shipped_name);
  scenario.sensors.every.noise_percent = noise_percent;
  return scenario;
}

host_sim::Scenario with_cycles(host_sim::Scenario scenario, double cycles) {
  for (host_sim::ExcitationLevel& level : scenario.levels)
    level.samples = static_cast<size_t>(std::llround(cycles * scenario.sample_rate_Hz / level.frequency_Hz));
  return scenario;
}

std::vector<Case> noisy_cases() {
  std::vector<Case> cases;
  cases.push_back(shipped("paper_1dof", "1 DOF, sine at two levels"));
  cases.push_back(
      shipped("paper_2dof_noise", "2 DOF, sine at three levels, one cycle of each", {5.84, 13.73, 5.96, 10.29}));
  cases.push_back({"paper_2dof_64_cycles",
                   "2 DOF, sine at three levels, 64 cycles of each",
                   with_cycles(with_noise("paper_2dof", 5.0), 64.0),
                   {}});
  cases.push_back(shipped("paper_3dof_two_frequencies_noise", "3 DOF, sine of 5 and of 10 Hz, 20 s each",
                          {19.70, 17.25, 18.45, 20.08, 0.85}));
  cases.push_back(shipped("paper_3dof_random_noise", "3 DOF, random force at two levels, 20 s each",
                          {19.9986, 20.0010, 19.9990, 20.0004, 0.99995}));
  cases.push_back(shipped("paper_3dof_free_decay", "3 DOF, free decay from two initial states"));
  cases.push_back({"fork_4dof_random",
                   "own rig: forked, 4 DOF, random force at two levels, 20 s each",
                   host_sim::parse_scenario(kFork, "fork_4dof_random"),
                   {}});
  cases.push_back({"frame_2dof_sine",
                   "own rig: heavy frame, 2 DOF, sine of 10 and 12.5 Hz, 20 s each",
                   host_sim::parse_scenario(kFrame, "frame_2dof_sine"),
                   {}});
  return cases;
}

std::vector<CleanCase> clean_cases() {
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {{"paper_1dof", host_sim::load_scenario("paper_1dof"), 0.1, none},
          {"paper_2dof", host_sim::load_scenario("paper_2dof"), 0.1, 0.58},
          {"paper_3dof_two_frequencies", host_sim::load_scenario("paper_3dof_two_frequencies"), 0.1, 0.95},
          {"paper_3dof_random", host_sim::load_scenario("paper_3dof_random"), 0.02, 0.018},
          {"paper_3dof_free_decay", host_sim::load_scenario("paper_3dof_free_decay"), 0.2, none}};
}

}  // namespace accuracy
