// The rig that the tests of dialects are read for.
#pragma once
#include <string>

#include "hal/rig_file/toml/rig_reader.hpp"

namespace two_dofs {

// A mass (DOF 1) and a disc (DOF 2) with dampers to ground; `more` may hold [[channel]] tables.
inline rig_file::RigModel rig(const std::string& more = "") {
  return rig_file::parse_rig(
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 1\n[[dof]]\ninertia_kg_m2 = 1\n"
      "[[link]]\nbetween = [1, 0]\nviscous_N_s_m = \"estimate\"\n"
      "[[link]]\nbetween = [2, 0]\nviscous_N_m_s_rad = \"estimate\"\n" +
          more,
      "rig.toml");
}

}  // namespace two_dofs
