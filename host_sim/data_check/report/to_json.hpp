// The check as JSON, schema check/1 (docs/formats.md), and in words.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

nlohmann::ordered_json to_json(const Report& report);

// "file: channel: kind: detail", one line for each finding of at least this weight, each once.
std::vector<std::string> lines_of(const Report& report, Weight least);

}  // namespace host_sim::data_check
