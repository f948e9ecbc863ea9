// Sensitivities of sensors whose column is a voltage.
#pragma once
#include <optional>
#include <string>

#include "host_sim/records/columns/units/units.hpp"

namespace host_sim {

// "100 mV/g", "2.25 mV/N", "0.5 V/(mm/s)": volts per SI unit, and what is measured. Nothing where it is none.
struct Sensitivity {
  Dimension dimension;
  double volts_per_si = 1.0;
};
std::optional<Sensitivity> parse_sensitivity(const std::string& text);

}  // namespace host_sim
