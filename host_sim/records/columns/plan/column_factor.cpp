#include "host_sim/records/columns/plan/column_factor.hpp"

#include <fmt/format.h>

#include "host_sim/records/columns/plan/column_choices.hpp"
#include "host_sim/records/columns/quoted.hpp"
#include "host_sim/records/columns/units/sensitivity.hpp"

namespace host_sim {

std::string said_factor(double factor) { return fmt::format(": values times {:.10g}", factor); }

void find_factor(const ColumnContext& context, const Column& column, const Reading& reading, ColumnUse& use,
                 std::vector<std::string>& notes) {
  const Dimension wanted = reading.dimension;
  const std::string& unit = reading.unit;
  const std::string& name = use.channel.name;
  const std::string from = trimmed_text(column.head) == name ? "" : " from column " + quoted_head(column);
  const std::string sensor =
      chosen(context.options.sensitivities, context.model, name, &rig_file::ChannelEntry::sensitivity);
  if (unit.empty() && sensor.empty()) {
    if (reading.mapped) notes.push_back(name + from + ": no unit is given, taken as " + si_unit(wanted));
    return;
  }
  if (!sensor.empty() && !parse_sensitivity(sensor))
    context.refuse(name + ": " + quoted(sensor) + " is no sensitivity, expected one such as \"100 mV/" +
                   si_unit(wanted) + "\"");
  const auto found = find_scaled_unit(unit.empty() ? "V" : unit, wanted);
  if (!found)
    context.refuse("column " + quoted_head(column) + " is in " + quoted(unit) + ", which is no known unit; expected " +
                   si_unit(wanted) + " or the like, or --unit");
  std::string how = " in " + found->word;
  if (found->dimension == Dimension::kVoltage && wanted != Dimension::kVoltage) {
    const auto sensitivity = parse_sensitivity(sensor);
    if (!sensitivity || sensitivity->dimension != wanted)
      context.refuse("column " + quoted_head(column) +
                     " is a voltage; expected its sensor's sensitivity, as in --sensitivity " +
                     name.substr(0, name.find('_', name.find('_') + 1)) + "=\"100 mV/" + si_unit(wanted) + "\"" +
                     (sensor.empty() ? "" : ", found " + quoted(sensor)));
    use.factor = found->to_si / sensitivity->volts_per_si;
    how += " at " + sensor;
  } else if (found->dimension != wanted) {
    context.refuse("column " + quoted_head(column) + " is in " + found->word + ", expected a unit such as " +
                   si_unit(wanted) + " for " + name);
  } else {
    use.factor = found->to_si;
    if (!sensor.empty()) how += " (no voltage: its sensitivity of " + sensor + " is not used)";
  }
  if (use.factor != 1.0) {
    notes.push_back(name + from + how + said_factor(use.factor));
  } else if (!from.empty() || !sensor.empty()) {
    notes.push_back(name + from + how);
  }
}

}  // namespace host_sim
