// Which rigs a spring ties to the ground.
#pragma once
#include "firmware/vocabulary/kinds.hpp"
#include "hal/rig_file/rig_model.hpp"

namespace vocabulary {

// Does the force of a kind always pull a link back to its middle, however far it goes? By its law: force times elongation
// is nowhere negative, and positive far out.
bool pulls_back(firmware::EffectKind kind);

// Does every DOF have a way to the ground or the base by springs: links with a positive (or unknown) coefficient that pulls
// back, own terms and corrections summed? Where not, nothing pulls a simulation back to the measurement.
bool held_in_place(const rig_file::RigModel& rig);
// No DOF has a mass, or may have: forces answer an imposed motion.
bool massless(const rig_file::RigModel& rig);

}  // namespace vocabulary
