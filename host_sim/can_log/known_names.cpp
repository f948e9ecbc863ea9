#include "host_sim/can_log/known_names.hpp"

#include <cmath>

#include "firmware/vocabulary/effect_table.hpp"
#include "host_sim/can_log/readable.hpp"

namespace can_log {
namespace {

struct Units {
  const char* translating;
  const char* rotating;
};
constexpr Units kChannelUnits[] = {{"N", "N m"}, {"m", "rad"}, {"m/s", "rad/s"}, {"m/s^2", "rad/s^2"}};

}  // namespace

std::string place_label(int place) {
  if (place == firmware::can::kPlaceBase) return "base";
  return std::to_string(place);
}

std::string parameter_label(const firmware::ParameterDescription& parameter) {
  const std::string kind =
      state_name(firmware::can::states(firmware::can::kParameterKinds), static_cast<int64_t>(parameter.kind));
  std::string label = (kind.empty() ? "kind" + std::to_string(static_cast<int>(parameter.kind)) : kind) + "[" +
                      place_label(parameter.place_a);
  if (parameter.place_b != firmware::can::kPlaceNone) label += "-" + place_label(parameter.place_b);
  return label + "]";
}

std::string channel_label(int place, int quantity) {
  const std::string name = state_name(firmware::can::states(firmware::can::kQuantities), quantity);
  return (name.empty() ? "quantity " + std::to_string(quantity) : name) + "[" + place_label(place) + "]";
}

std::string parameter_unit(firmware::TermKind kind, bool rotating) {
  if (static_cast<int>(kind) >= firmware::kTermKinds) return "SI";
  const firmware::Unit& unit = firmware::row_of(kind).unit;
  return unit.of(rotating || unit.translating == nullptr);
}

std::string channel_unit(int quantity, bool rotating) {
  if (quantity < 0 || quantity >= firmware::kQuantities) return "SI";
  return rotating ? kChannelUnits[quantity].rotating : kChannelUnits[quantity].translating;
}

int quantity_of(const std::string& signal_name) {
  for (const firmware::can::NamedValue& entry : firmware::can::kQuantities)
    if (entry.name == signal_name && entry.value < firmware::kQuantities) return entry.value;
  return -1;
}

void KnownNames::learn(const firmware::CanFrame& message) {
  int node = 0;
  firmware::ParameterDescription parameter;
  firmware::ChannelScaling scaling;
  firmware::ChannelRange range;
  if (firmware::unpack_parameter(message, node, parameter)) {
    if (parameter.index < firmware::kMaxUnknowns) parameters_[node][parameter.index] = Parameter{true, parameter};
  } else if (firmware::unpack_scaling(message, node, scaling)) {
    Channel& channel = channels_[scaling.place][static_cast<int>(scaling.quantity)];
    channel.scaling_known = true;
    channel.scaling = scaling;
  } else if (firmware::unpack_range(message, node, range)) {
    Channel& channel = channels_[range.place][static_cast<int>(range.quantity)];
    channel.range_known = true;
    channel.range = range;
  }
}

std::string KnownNames::parameter(int node, int index) const {
  const Parameter& parameter = parameters_[node][index];
  return parameter.known ? parameter_label(parameter.description) : "estimate " + std::to_string(index);
}

std::string KnownNames::unit(int node, int index) const {
  const Parameter& parameter = parameters_[node][index];
  return parameter.known ? parameter_unit(parameter.description.kind, parameter.description.rotating) : "SI";
}

bool KnownNames::knows(int node, int index) const { return parameters_[node][index].known; }

bool KnownNames::rotates(int node, int place) const {
  for (const Parameter& parameter : parameters_[node])
    if (parameter.known && parameter.description.rotating &&
        (parameter.description.place_a == place || parameter.description.place_b == place))
      return true;
  for (const Channel& channel : channels_[place & 31])
    if (channel.scaling_known && channel.scaling.rotating) return true;
  return false;
}

bool KnownNames::in_si_units(int place, int quantity, int64_t code, double& value, std::string& unit) const {
  const Channel& channel = channels_[place][quantity];
  if (!channel.scaling_known || !channel.range_known) return false;
  const double counts = static_cast<double>(code - channel.range.offset_code) * channel.scaling.unit_per_code;
  const int exponent = channel.scaling.exponent;
  value = exponent < 0 ? counts / std::pow(10.0, -exponent) : counts * std::pow(10.0, exponent);
  unit = channel_unit(quantity, channel.scaling.rotating);
  return true;
}

std::string KnownNames::in_units(int place, int quantity, int64_t code) const {
  double value = 0.0;
  std::string unit;
  return in_si_units(place, quantity, code, value, unit) ? " = " + number_text(value, 7) + " " + unit : "";
}

}  // namespace can_log
