// What the balance of energies says of numbers that free runs leave more than noise with.
//
// Runs compare motions: a force that is missing near a resonance hides in a damper, and what it leaves looks like noise of some colour. The
// balance of energies simulates nothing, reads the noise's colour, and tests forces against what it leaves.
#pragma once
#include <vector>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Where the diagnosis is content (none, explained) with a rig that leaves over three times the noise in the motion's band, `estimate` is
// asked of that rig and the same records. Numbers that it withdraws because the model or the instruments contradict them may be bent;
// `explained` is then `partly`. Nothing is changed where it cannot be asked: of channels'
// faults that a rig file does not state, of effects that the simulator alone knows.
void ask_energies(const std::vector<Record>& records, diagnosis::Diagnosis& found);

}  // namespace host_sim
