// What the user says about data files beyond what stands in them.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "host_sim/records/times/time_span.hpp"

namespace host_sim {

struct ReadingOptions {
  // Channel and text, in the order of the command line. A channel is named with or without its unit: "force_1" or
  // "force_1_N"; the time is "t" or "t_s".
  using Choices = std::vector<std::pair<std::string, std::string>>;
  Choices columns;              // the column that holds it: "Chan 3"; empty: the channel is left out
  Choices units;                // the unit it is in: "g"
  Choices sensitivities;        // of a sensor whose column is a voltage: "100 mV/g"
  double sample_rate_Hz = 0.0;  // 0: the file says
  double resample_Hz = 0.0;     // onto even steps (resample.hpp); 0: uneven times are refused
  TimeSpan span = {};           // of every record
};

// "acceleration_1=Chan 3" as given on the command line. Throws std::invalid_argument where there is no "=".
std::pair<std::string, std::string> parse_choice(const std::string& text);

}  // namespace host_sim
