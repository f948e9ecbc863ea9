// What is loud in a record, by the energies of its windows.
#pragma once
#include <functional>
#include <vector>

namespace host_sim::data_check {

// The energy above which a window is loud: less is no blow worth a decay, and no decay worth its record.
double loud_energy(const std::vector<double>& energy);

// Whether decays are what the record shows when it is loud; else something drives the rig, or a motor's speed goes up and down.
bool decays_enough(const std::vector<double>& energy, const std::function<bool(size_t)>& is_in_decay);

}  // namespace host_sim::data_check
