#include "host_sim/vocabulary/said.hpp"

#include <algorithm>
#include <map>

namespace vocabulary {

std::string said(const std::string& effect, const std::string& where) {
  static const std::map<std::string, std::string> kCalled = {{"missing_coulomb", "Coulomb friction"},
                                                             {"missing_viscous", "viscous damping"},
                                                             {"missing_gravity_torque", "gravity torque"}};
  const auto called = kCalled.find(effect);
  std::string words = called != kCalled.end() ? called->second : effect;
  std::replace(words.begin(), words.end(), '_', ' ');
  if (where.empty()) return words;
  if (where.rfind("channel ", 0) == 0) return words + " in " + where;
  return words + " on " + (where.rfind("dof ", 0) == 0 ? "DOF" + where.substr(3) : where);
}

}  // namespace vocabulary
