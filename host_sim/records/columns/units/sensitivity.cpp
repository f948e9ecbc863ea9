#include "host_sim/records/columns/units/sensitivity.hpp"

#include "host_sim/records/columns/units/counted.hpp"

namespace host_sim {

std::optional<Sensitivity> parse_sensitivity(const std::string& text) {
  const auto counted = take_count(text);
  if (!counted) return std::nullopt;
  const std::string_view rest = counted->rest;
  const size_t slash = rest.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto volts = find_unit(rest.substr(0, slash), Dimension::kVoltage), per = find_unit(rest.substr(slash + 1));
  if (!volts || volts->dimension != Dimension::kVoltage || !per) return std::nullopt;
  if (per->dimension == Dimension::kTime || per->dimension == Dimension::kVoltage) return std::nullopt;
  return Sensitivity{per->dimension, counted->count * volts->to_si / per->to_si};
}

}  // namespace host_sim
