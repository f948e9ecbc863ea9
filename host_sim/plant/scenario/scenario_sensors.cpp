#include <algorithm>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/plant/motion/motion_record.hpp"
#include "host_sim/plant/scenario/scenario_parts.hpp"

namespace host_sim {
namespace {

using rig_file::Place;
using rig_file::refuse;

constexpr const char* kQuantityWords[] = {"force", "displacement", "velocity", "acceleration"};
const std::vector<std::string> kChannelKeys = {"noise_percent", "noise_corner_Hz", "bits",    "full_scale",
                                               "offset",        "drift_per_s",     "delay_us"};

double at_least_zero(const Place& place, const toml::node& node, const char* key) {
  const double value = rig_file::finite_number(place, node, key);
  if (value < 0.0) refuse(place, node, key, "is " + std::to_string(value) + ", expected 0 or more");
  return value;
}

void read_channel_keys(const Place& place, const toml::table& table, SensorChannel& sensor) {
  if (const auto* node = table.get("noise_percent"))
    sensor.noise_percent = at_least_zero(place, *node, "noise_percent");
  if (const auto* node = table.get("noise_corner_Hz"))
    sensor.noise_corner_Hz = at_least_zero(place, *node, "noise_corner_Hz");
  if (const auto* node = table.get("full_scale")) {
    sensor.full_scale = at_least_zero(place, *node, "full_scale");
    if (sensor.full_scale == 0.0)
      refuse(place, *node, "full_scale", "is 0, expected the largest value that the sensor can show");
  }
  if (const auto* node = table.get("offset")) sensor.offset = rig_file::finite_number(place, *node, "offset");
  if (const auto* node = table.get("drift_per_s"))
    sensor.drift_per_s = rig_file::finite_number(place, *node, "drift_per_s");
  if (const auto* node = table.get("delay_us")) {
    sensor.delay_us = rig_file::finite_number(place, *node, "delay_us");
    if (sensor.delay_us < 0.0 || sensor.delay_us > 1e6)
      refuse(place, *node, "delay_us", "is out of range, expected 0 to 1e6");
  }
  if (const auto* node = table.get("bits"))
    sensor.bits = static_cast<int>(rig_file::whole_number(place, *node, "bits", 8, 24));
}

void read_quantities(const Place& place, const toml::node& node, SensorSettings& sensors) {
  const std::string expected = "expected a list of \"force\", \"displacement\", \"velocity\", \"acceleration\"";
  const toml::array* list = node.as_array();
  if (list == nullptr || list->empty()) refuse(place, node, "channels", "is not a list, " + expected);
  sensors.quantities.clear();
  for (const toml::node& element : *list) {
    const std::string word = rig_file::text(place, element, "channels");
    const auto* found = std::find(std::begin(kQuantityWords), std::end(kQuantityWords), word);
    if (found == std::end(kQuantityWords)) refuse(place, element, "channels", "holds \"" + word + "\", " + expected);
    sensors.quantities.push_back(static_cast<Quantity>(found - std::begin(kQuantityWords)));
  }
}

void read_channel(const Place& place, const toml::table& table, const Scenario& scenario, SensorSettings& sensors) {
  std::vector<std::string> known = kChannelKeys;
  known.insert(known.begin(), {"name", "present"});
  rig_file::require_known_keys(place, table, known);
  const toml::node* name_node = table.get("name");
  if (name_node == nullptr) refuse(place, table, "name", "is missing, expected a channel such as \"displacement_1_m\"");
  const std::string name = rig_file::text(place, *name_node, "name");
  const std::string fault = rig_file::channel_name_fault(name, scenario.rig);
  if (!fault.empty()) refuse(place, *name_node, "name", fault);
  if (sensors.channel.count(name) > 0)
    refuse(place, *name_node, "name", "repeats an earlier channel, expected each once");
  SensorChannel sensor = sensors.every;
  read_channel_keys(place, table, sensor);
  sensors.channel[name] = sensor;
  if (const toml::node* present = table.get("present")) {
    const auto value = present->value_exact<bool>();
    if (!value) refuse(place, *present, "present", "is neither true nor false, expected one of them");
    if (!*value) sensors.absent.push_back(name);
  }
}

// Every DOF must show some motion, else nothing can be estimated about it.
void check_motion(const Place& top, const toml::table& root, const Scenario& scenario, const SensorSettings& sensors) {
  for (size_t i = 0; i < scenario.rig.dofs.size(); ++i) {
    bool seen = false;
    for (Quantity quantity : sensors.quantities) {
      const std::string name = channel_name(quantity, static_cast<int>(i + 1), scenario.rig.dofs[i].rotating);
      seen |= quantity != Quantity::kForce &&
              std::find(sensors.absent.begin(), sensors.absent.end(), name) == sensors.absent.end();
    }
    if (!seen)
      refuse(top, root, "sensors",
             "leaves DOF " + std::to_string(i + 1) +
                 " without any motion channel, expected displacement, velocity or acceleration");
  }
}

}  // namespace

void read_sensors(const Place& top, const toml::table& root, Scenario& scenario) {
  const toml::node* node = root.get("sensors");
  if (node == nullptr) return;
  const toml::table* table = node->as_table();
  if (table == nullptr) refuse(top, *node, "sensors", "is not a table, expected [sensors]");
  const Place place{top.file, "[sensors]"};
  std::vector<std::string> known = kChannelKeys;
  known.insert(known.begin(), {"channels", "headroom", "channel"});
  rig_file::require_known_keys(place, *table, known);
  SensorSettings& sensors = scenario.sensors;
  read_channel_keys(place, *table, sensors.every);
  if (const toml::node* list = table->get("channels")) read_quantities(place, *list, sensors);
  if (const toml::node* headroom = table->get("headroom")) {
    sensors.headroom = rig_file::finite_number(place, *headroom, "headroom");
    if (sensors.headroom < 1.0)
      refuse(place, *headroom, "headroom", "is below 1, expected full scale over the largest value");
  }
  size_t number = 0;
  for (const toml::table* channel : rig_file::table_array(place, *table, "channel"))
    read_channel({top.file, "sensors.channel " + std::to_string(++number)}, *channel, scenario, sensors);
  check_motion(top, *node->as_table(), scenario, sensors);
}

}  // namespace host_sim
