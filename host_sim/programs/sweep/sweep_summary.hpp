// What many runs say together, per scenario and parameter.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace host_sim {

// Per scenario and parameter: name, unit, truth, runs, bias and rms of the error, mean of the reported standard
// deviation, the percentage of 95 % intervals that hold the truth, and how often each status came.
nlohmann::ordered_json summarise(const std::vector<nlohmann::ordered_json>& runs);

std::string format_summary(const nlohmann::ordered_json& summary);

}  // namespace host_sim
