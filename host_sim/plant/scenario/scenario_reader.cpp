// Reads a scenario file (schema "scenario/1"); every fault names file, line, key and what was expected.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "hal/rig_file/channel_name.hpp"
#include "hal/rig_file/coefficient_walk.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/toml/rig_from_toml.hpp"
#include "hal/rig_file/toml/toml_checks.hpp"
#include "host_sim/plant/motion/equations.hpp"
#include "host_sim/plant/plant_error.hpp"
#include "host_sim/plant/scenario/scenario.hpp"
#include "host_sim/plant/scenario/scenario_parts.hpp"

namespace host_sim {
namespace {

using rig_file::Place;
using rig_file::refuse;

const std::vector<std::string> kScenarioKeys = {"description", "sample_rate_Hz", "rig",    "plant",
                                                "truth",       "level",          "sensors"};

void check_schema(const Place& top, toml::table& root) {
  const toml::node* schema = root.get("schema");
  if (schema == nullptr) refuse(top, root, "schema", "is missing, expected schema = \"scenario/1\"");
  const std::string found = rig_file::text(top, *schema, "schema");
  if (found != "scenario/1") refuse(top, *schema, "schema", "is \"" + found + "\", expected \"scenario/1\"");
  root.insert_or_assign("schema", "rig/1");  // so that the rig's own reader takes the table
}

rig_file::RigModel read_rig(const Place& top, const toml::table& root) {
  const toml::node* path = root.get("rig");
  if (path == nullptr) {
    if (root.get("dof") == nullptr)
      refuse(top, root, "rig",
             "is missing, expected rig = \"file.toml\", or [[dof]] and [[link]] tables in the scenario itself");
    rig_file::ReadOptions options;
    options.other_top_level_keys = kScenarioKeys;
    return rig_file::rig_from_toml(root, top.file, options);
  }
  for (const char* key : {"dof", "link", "channel"})
    if (const toml::node* node = root.get(key))
      refuse(top, *node, key, "stands beside rig = \"file\", expected the rig in one place: there or here");
  return rig_file::read_rig_file(beside(top.file, rig_file::text(top, *path, "rig")));
}

std::vector<double> read_truth(const Place& top, const toml::table& root, const rig_file::RigModel& rig) {
  const std::vector<std::string> names = rig_file::parameter_names(rig);
  const Place place{top.file, "[truth]"};
  const toml::node* node = root.get("truth");
  if (node == nullptr) {
    if (names.empty()) return {};
    refuse(top, root, "truth",
           "is missing, expected a table [truth] with a number for every coefficient to be estimated (\"" + names[0] +
               "\" = ...)");
  }
  const toml::table* table = node->as_table();
  if (table == nullptr) refuse(top, *node, "truth", "is not a table, expected [truth]");
  rig_file::require_known_keys(place, *table, names);
  std::vector<double> truth;
  for (const std::string& name : names) {
    const toml::node* value = table->get(name);
    if (value == nullptr) refuse(place, *table, name, "is missing, expected the number that the simulated rig has");
    truth.push_back(rig_file::finite_number(place, *value, name));
  }
  return truth;
}

rig_file::RigModel read_plant(const Place& top, const toml::table& root, const Scenario& scenario) {
  const toml::node* path = root.get("plant");
  if (path == nullptr) return rig_file::with_values(scenario.rig, scenario.truth);
  rig_file::RigModel plant = rig_file::read_rig_file(beside(top.file, rig_file::text(top, *path, "plant")));
  if (plant.dofs.size() != scenario.rig.dofs.size())
    refuse(top, *path, "plant",
           "has " + std::to_string(plant.dofs.size()) + " DOFs, expected " + std::to_string(scenario.rig.dofs.size()) +
               " as the rig has");
  const std::vector<std::string> names = rig_file::parameter_names(scenario.rig);
  rig_file::walk_coefficients(plant, [&](const rig_file::CoefficientSite& site, rig_file::Coefficient& coefficient) {
    const auto found = std::find(names.begin(), names.end(), site.name);
    if (!coefficient.estimate || found == names.end()) return;
    coefficient = {scenario.truth[static_cast<size_t>(found - names.begin())], false};
  });
  return plant;
}

// What only the simulator knows to be impossible (a DOF without mass, an effect without its shape).
void check_plant(const Place& top, const toml::table& root, const rig_file::RigModel& plant) {
  try {
    Equations equations(plant);
  } catch (const PlantError& error) {
    refuse(top, root, root.get("plant") != nullptr ? "plant" : "", error.what());
  }
}

}  // namespace

std::string beside(const std::string& file, const std::string& path) {
  const std::filesystem::path other(path);
  return other.is_absolute() ? path : (std::filesystem::path(file).parent_path() / other).string();
}

Scenario parse_scenario(std::string_view toml_text, const std::string& file) {
  toml::table root = rig_file::parse_toml(toml_text, file);
  const Place top{file, ""};
  check_schema(top, root);
  std::vector<std::string> known = {"schema", "name", "dof", "link", "channel"};
  known.insert(known.end(), kScenarioKeys.begin(), kScenarioKeys.end());
  rig_file::require_known_keys(top, root, known);
  Scenario scenario;
  scenario.rig = read_rig(top, root);
  if (const toml::node* name = root.get("name")) scenario.name = rig_file::text(top, *name, "name");
  if (const toml::node* text = root.get("description"))
    scenario.description = rig_file::text(top, *text, "description");
  if (const toml::node* rate = root.get("sample_rate_Hz")) {
    scenario.sample_rate_Hz = rig_file::finite_number(top, *rate, "sample_rate_Hz");
    if (scenario.sample_rate_Hz < 1.0 || scenario.sample_rate_Hz > 1e6)
      refuse(top, *rate, "sample_rate_Hz", "is out of range, expected 1 to 1e6");
  }
  scenario.truth = read_truth(top, root, scenario.rig);
  scenario.plant = read_plant(top, root, scenario);
  check_plant(top, root, scenario.plant);
  read_levels(top, root, scenario);
  read_sensors(top, root, scenario);
  return scenario;
}

Scenario read_scenario_file(const std::string& path) {
  std::string text;
  {
    rig_file::parse_toml_file(path);  // names a file that cannot be read, or a line that is not TOML
    std::ifstream stream(path, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return parse_scenario(text, path);
}

Scenario load_scenario(const std::string& name_or_file) {
  const std::string text = shipped_scenario_text(name_or_file);
  if (!text.empty()) return parse_scenario(text, name_or_file);
  if (std::filesystem::exists(name_or_file)) return read_scenario_file(name_or_file);
  std::string names;
  for (const std::string& name : shipped_scenario_names()) names += (names.empty() ? "" : ", ") + name;
  throw rig_file::RigFileError(name_or_file, 0, "",
                               "is no scenario, expected the path of a scenario file or one of " + names);
}

}  // namespace host_sim
