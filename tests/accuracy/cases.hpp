// The measured cases of the accuracy report: the paper's scenarios and two rigs of our own, with noise on every
// channel.
#pragma once
#include <string>
#include <vector>

#include "host_sim/plant/scenario/scenario.hpp"

namespace accuracy {

struct Case {
  std::string name;
  std::string title;
  host_sim::Scenario scenario;  // sensors carry the noise
  std::vector<double> paper;    // the paper's single estimates under the same noise; empty where it gives none
};

std::vector<Case> noisy_cases();

struct CleanCase {
  std::string name;
  host_sim::Scenario scenario;
  double limit_percent;  // worst error allowed, clean data of 24 bits
  double paper_percent;  // worst error of the paper's own clean estimates; NaN where it gives none
};
std::vector<CleanCase> clean_cases();

// A shipped scenario with this noise on every channel.
host_sim::Scenario with_noise(const std::string& shipped_name, double noise_percent);
// A shipped scenario of sine levels with so many cycles measured at each.
host_sim::Scenario with_cycles(host_sim::Scenario scenario, double cycles);

}  // namespace accuracy
