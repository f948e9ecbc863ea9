// Units that rigs come in, and their factor to SI.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "firmware/configuration/configuration.hpp"

namespace host_sim {

// What a unit measures: a quantity of a translating or rotating DOF, a time or a voltage.
enum class Dimension {
  kForce,
  kDisplacement,
  kVelocity,
  kAcceleration,
  kTorque,
  kAngle,
  kAngularVelocity,
  kAngularAcceleration,
  kTime,
  kVoltage
};

Dimension dimension_of(firmware::Quantity quantity, bool rotating);
const char* si_unit(Dimension dimension);  // "m/s2"

struct Unit {
  std::string word;     // as the table spells it: "mm/s"
  Dimension dimension;  // what it measures
  double to_si = 1.0;   // a value times this is in SI units (N, m, rad, s, V)
};

// "mm", "(m/s^2)", "[g]", "N·m", "µm", "°/s", "lbf-ft", "1/min": brackets, blanks and the usual spellings are
// understood, upper and lower case matter ("mN", "MN") unless only one reading exists. Nothing where it is no unit.
// A word that names units of two dimensions ("N m" is no length) is looked for in `expected` first.
std::optional<Unit> find_unit(std::string_view text, std::optional<Dimension> expected = std::nullopt);
// The same, or so many of them: "17.857 um" is what a step of an encoder is worth, "-1 g" an accelerometer that is turned over.
std::optional<Unit> find_scaled_unit(const std::string& text, Dimension expected);
// The end of a column name, where "/" and "." are written "_": "mm_s2", "kN_m".
std::optional<Unit> find_unit_suffix(std::string_view suffix, Dimension expected);

}  // namespace host_sim
