// The estimates as JSON, schema estimate/1 (docs/formats.md).
#pragma once
#include <nlohmann/json.hpp>

#include "host_sim/programs/results/estimate_result.hpp"

namespace host_sim {

nlohmann::ordered_json to_json(const EstimateResult& result);
std::string to_text(const nlohmann::ordered_json& json);  // indented, with a line end

}  // namespace host_sim
