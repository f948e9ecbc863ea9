#include "host_sim/reports/sections/at_fault.hpp"

namespace host_sim::reports {
namespace {

// A force that the drive does not give is told by its channel as well: the sensor is sound.
constexpr const char* kDeadBand = "drive_dead_band";

std::string joined(const std::string& a, const char* word, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + word + b;
}

}  // namespace

bool of_channel(const std::string& where) { return where.rfind("channel ", 0) == 0; }

bool AtFault::add(const std::string& effect, const std::string& where) {
  if (!of_channel(where) || effect == kForceHold) return false;
  ++(effect == kDeadBand ? drives : sensors);
  return true;
}

std::string at_fault_text(const AtFault& faults) {
  const std::string sensors = faults.sensors > 1 ? "sensors" : faults.sensors == 1 ? "a sensor" : "";
  const std::string drives = faults.drives > 1 ? "drives" : faults.drives == 1 ? "the drive" : "";
  return joined(sensors, " and ", drives) + (faults.all() > 1 ? " are at fault" : " is at fault");
}

std::string one_at_fault_text(const AtFault& possible) {
  return joined(possible.sensors > 0 ? "a sensor" : "", " or ", possible.drives > 0 ? "a drive" : "") + " is at fault";
}

}  // namespace host_sim::reports
