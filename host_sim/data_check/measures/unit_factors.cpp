#include "host_sim/data_check/measures/unit_factors.hpp"

#include <cmath>

namespace host_sim::data_check {

std::optional<std::string> unit_reading(Dimension dimension, double factor, double tolerance) {
  // In the order of how often rigs come in them.
  for (const char* word : {"g",    "mm",   "kN",    "deg",  "mm/s",  "rpm",    "mm/s2", "um",   "cm",     "inch",
                           "in/s", "lbf",  "kgf",   "mN",   "deg/s", "deg/s2", "mrad",  "rev",  "rev/s",  "mg",
                           "ft",   "ft/s", "ft/s2", "um/s", "N mm",  "mN m",   "kN m",  "N cm", "lbf in", "lbf ft"}) {
    const auto unit = find_unit(word, dimension);
    if (unit && unit->dimension == dimension && std::abs(std::log(factor * unit->to_si)) < tolerance) return word;
  }
  return std::nullopt;
}

}  // namespace host_sim::data_check
