// Small rigs whose motion can be worked out by hand.
#pragma once
#include "hal/rig_file/rig_model.hpp"

namespace plant_test {

inline rig_file::RigModel oscillator(double m, double k, double c = 0.0, double coulomb = 0.0, int other_end = 0) {
  rig_file::RigModel rig;
  rig.dofs.resize(1);
  rig.dofs[0].mass_kg.value = m;
  rig_file::Link link;
  link.a = 1;
  link.b = other_end;
  link.stiffness_N_m.value = k;
  link.viscous_N_s_m.value = c;
  link.coulomb_N.value = coulomb;
  rig.links.push_back(link);
  return rig;
}

inline rig_file::Effect effect(const char* kind, double coefficient, const char* key = nullptr, double shape = 0.0) {
  rig_file::Effect result;
  result.kind = kind;
  result.coefficient.value = coefficient;
  if (key != nullptr) result.shape[key] = shape;
  return result;
}

}  // namespace plant_test
