// What a log says of itself: names and units of the estimates of each node, and the scaling of the sensor channels,
// collected from the description frames as they pass.
#pragma once
#include <string>

#include "firmware/can_protocol/can_frame.hpp"
#include "firmware/can_protocol/messages/messages.hpp"
#include "firmware/can_protocol/messages/packing.hpp"

namespace can_log {

// "1", "0" for ground, "base"; "viscous[1-2]", "mass[1]", "displacement[base]".
std::string place_label(int place);
std::string parameter_label(const firmware::ParameterDescription& parameter);
std::string channel_label(int place, int quantity);
// SI units; "SI" for a kind that is not known.
std::string parameter_unit(firmware::TermKind kind, bool rotating);
std::string channel_unit(int quantity, bool rotating);
int quantity_of(const std::string& signal_name);  // -1: the signal is no channel

class KnownNames {
 public:
  void learn(const firmware::CanFrame& message);
  // "estimate 3" with unit "SI" as long as no description has been seen.
  std::string parameter(int node, int index) const;
  std::string unit(int node, int index) const;
  bool knows(int node, int index) const;  // a description has been seen
  // Whether an estimate of that node or a channel is said to be of a DOF that turns there.
  bool rotates(int node, int place) const;
  // False as long as the scaling of the channel is not known; value and unit then stay as they are.
  bool in_si_units(int place, int quantity, int64_t code, double& value, std::string& unit) const;
  // " = 1.25e-05 m" for a code of a channel whose scaling is known, else nothing.
  std::string in_units(int place, int quantity, int64_t code) const;

 private:
  struct Parameter {
    bool known = false;
    firmware::ParameterDescription description;
  };
  struct Channel {
    bool scaling_known = false, range_known = false;
    firmware::ChannelScaling scaling;
    firmware::ChannelRange range;
  };
  Parameter parameters_[firmware::can::kLastNode + 1][firmware::kMaxUnknowns];
  Channel channels_[32][firmware::kQuantities];  // by place and quantity
};

}  // namespace can_log
