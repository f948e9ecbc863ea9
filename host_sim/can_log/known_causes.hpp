// What the nodes of a log say that their rigs lack, by the last `diagnosis` of each: name and unit of the size that follows it.
#pragma once
#include <string>

#include "firmware/can_protocol/messages/packing.hpp"
#include "host_sim/can_log/known_names.hpp"

namespace can_log {

// A size as numbers; std is 0 where the frame says so.
struct CauseSize {
  double value = 0.0, std = 0.0;
};
CauseSize size_of(const firmware::DecimalSize& size);

class KnownCauses {
 public:
  void learn(const firmware::CanFrame& message);
  // "cubic_stiffness[1-2]", "sensor_delay[velocity[1]]"; "size" as long as no cause is named (UNKNOWN has the size of the nearest, which is
  // told behind it).
  std::string label(int node) const;
  // Of the size; "SI" as long as no cause is named.
  std::string unit(int node, const KnownNames& names) const;

 private:
  firmware::Diagnosis last_[firmware::can::kLastNode + 1];
};

}  // namespace can_log
