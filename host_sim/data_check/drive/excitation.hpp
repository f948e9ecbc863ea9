// What drives the rig: tones or a band, levels, and what that cannot tell apart.
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

struct Drive {
  std::string channel;                // the strongest force, else the base; empty: a free decay
  double rms = 0.0;                   // about its mean
  double constant = 0.0;              // of a command that is held at one value, where nothing else drives
  std::vector<double> lines_Hz;       // where at most five lines hold 90 % of its power; else empty
  double from_Hz = 0.0, to_Hz = 0.0;  // the middle 90 % of its power
};
Drive drive_of(const Record& record);

// One finding for each record and, where there is one tone at one level, what to add. All inform. drives: one a record.
std::vector<Finding> describe_excitation(const std::vector<Record>& records, const std::vector<Drive>& drives);

}  // namespace host_sim::data_check
