#include <nlohmann/json.hpp>

#include "draw.hpp"

namespace hidden_rig {

std::string truth_json(uint64_t seed, const Settings& settings, const Draw& draw) {
  nlohmann::ordered_json out;
  out["schema"] = "hidden_rig/1";
  out["seed"] = seed;
  out["condition"] = settings.condition;
  out["sensors"] = settings.sensors;
  for (const TrueCoefficient& c : draw.coefficients)
    out["coefficients"].push_back({{"name", c.name}, {"value", c.value}, {"of_record", c.of_record}});
  out["hidden"] = nlohmann::ordered_json::array();
  for (const Hidden& h : draw.hidden)
    out["hidden"].push_back(
        {{"effect", h.effect}, {"where", h.where}, {"rho", h.rho}, {"strength", h.strength}, {"shape", h.shape}});
  out["redrawn"] = draw.redrawn;
  return out.dump(2) + "\n";
}

}  // namespace hidden_rig
