#include "host_sim/programs/sweep/sweep_summary.hpp"

#include <fmt/format.h>

#include <cmath>

namespace host_sim {
namespace {

using nlohmann::ordered_json;

struct Tally {
  std::string scenario, name, unit;
  double truth = 0.0, error = 0.0, square = 0.0, std = 0.0;
  unsigned runs = 0, held = 0;
  ordered_json statuses = ordered_json::object();

  void add(const ordered_json& parameter) {
    const double deviation = parameter["value"].get<double>() - truth;
    error += deviation;
    square += deviation * deviation;
    std += parameter["std"].get<double>();
    held += parameter["ci95"][0].get<double>() <= truth && truth <= parameter["ci95"][1].get<double>() ? 1 : 0;
    const std::string status = parameter["status"];
    statuses[status] = statuses.value(status, 0) + 1;
    ++runs;
  }
  ordered_json json() const {
    const double n = runs;
    return {{"scenario", scenario},
            {"name", name},
            {"unit", unit},
            {"truth", truth},
            {"runs", runs},
            {"bias", error / n},
            {"rms_error", std::sqrt(square / n)},
            {"mean_std", std / n},
            {"ci95_holds_percent", 100.0 * held / n},
            {"status", statuses}};
  }
};

}  // namespace

ordered_json summarise(const std::vector<ordered_json>& runs) {
  std::vector<Tally> tallies;
  for (const ordered_json& run : runs)
    for (const ordered_json& parameter : run["parameters"]) {
      const std::string scenario = run["scenario"], name = parameter["name"];
      size_t i = 0;
      while (i < tallies.size() && (tallies[i].scenario != scenario || tallies[i].name != name)) ++i;
      if (i == tallies.size()) {
        tallies.emplace_back();
        tallies[i].scenario = scenario;
        tallies[i].name = name;
        tallies[i].unit = parameter["unit"];
        tallies[i].truth = parameter["truth"];
      }
      tallies[i].add(parameter);
    }
  ordered_json summary = ordered_json::array();
  for (const Tally& tally : tallies) summary.push_back(tally.json());
  return summary;
}

std::string format_summary(const ordered_json& summary) {
  std::string text;
  std::string scenario;
  for (const ordered_json& row : summary) {
    if (row["scenario"] != scenario) {
      scenario = row["scenario"];
      text += fmt::format("{}{}, {} runs\n  {:<24} {:>10} {:>12} {:>12} {:>12} {:>8}  {}\n", text.empty() ? "" : "\n",
                          scenario, row["runs"].get<unsigned>(), "parameter", "truth", "bias", "rms error", "mean std",
                          "95 % ok", "status");
    }
    std::string statuses;
    for (const auto& [status, count] : row["status"].items())
      statuses += (statuses.empty() ? "" : ", ") + status + " " + std::to_string(count.get<unsigned>());
    text += fmt::format("  {:<24} {:10.4g} {:12.3g} {:12.3g} {:12.3g} {:6.1f} %  {}\n", row["name"].get<std::string>(),
                        row["truth"].get<double>(), row["bias"].get<double>(), row["rms_error"].get<double>(),
                        row["mean_std"].get<double>(), row["ci95_holds_percent"].get<double>(), statuses);
  }
  return text;
}

}  // namespace host_sim
