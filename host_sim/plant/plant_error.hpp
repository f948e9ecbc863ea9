// A rig or excitation that cannot be simulated; the message names the DOF, link or parameter and says what was
// expected.
#pragma once
#include <stdexcept>

namespace host_sim {

class PlantError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace host_sim
