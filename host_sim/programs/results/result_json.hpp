// The estimates as JSON, schema estimate/1 (docs/formats.md).
#pragma once
#include <nlohmann/json.hpp>

#include "host_sim/programs/results/estimate_result.hpp"

namespace host_sim {

nlohmann::ordered_json to_json(const EstimateResult& result);
// Indented, with a line end. What is no UTF-8 (a file's name on an old disk) is replaced by U+FFFD.
std::string to_text(const nlohmann::ordered_json& json);

}  // namespace host_sim
