#include "host_sim/ingestion/uff/uff_ordinate.hpp"

namespace host_sim::uff {

const char* ordinate_word(int type) {
  switch (type) {
    case 0:
      return "unknown";
    case 1:
      return "general";
    case 2:
      return "stress";
    case 3:
      return "strain";
    case 5:
      return "temperature";
    case 6:
      return "heat flux";
    case 8:
      return "displacement";
    case 9:
      return "reaction force";
    case 11:
      return "velocity";
    case 12:
      return "acceleration";
    case 13:
      return "excitation force";
    case 15:
      return "pressure";
    case 16:
      return "mass";
    case 17:
      return "time";
    case 18:
      return "frequency";
    case 19:
      return "rpm";
    default:
      return "not in the format's table";
  }
}

std::optional<firmware::Quantity> quantity_of(int ordinate_type) {
  switch (ordinate_type) {
    case 8:
      return firmware::Quantity::kDisplacement;
    case 11:
      return firmware::Quantity::kVelocity;
    case 12:
      return firmware::Quantity::kAcceleration;
    case 13:
      return firmware::Quantity::kForce;
    default:
      return std::nullopt;
  }
}

}  // namespace host_sim::uff
