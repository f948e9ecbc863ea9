// An effect and its place as a sentence says them; files and JSON have the vocabulary's own words.
#pragma once
#include <string>

namespace vocabulary {

// "quadratic damping on link 1-0", "mass error on DOF 2", "sensor delay in channel force_1_N"; without a place the effect alone. What a rig
// file may be missing is called by what it is: "Coulomb friction".
std::string said(const std::string& effect, const std::string& where);

}  // namespace vocabulary
