// Hum of the mains in motion channels: no motion, and taken out before causes are looked for.
#pragma once
#include "../choice/choice.hpp"

namespace diagnosis::runs {

// Takes out of the records' motion channels the lines of the mains that a model leaves, where nothing drives the rig at that frequency and
// they are a good part of what is left: of each record a sine of free frequency (within kMainsWidth_Hz), amplitude and phase,
// fitted to what the model leaves of its windows. Returns what was taken per channel, the largest amplitude of all records (SI units);
// empty: nothing.
std::vector<Hum> take_out_hum(const Task& task, const Choice& choice, std::vector<Prepared>& records);

}  // namespace diagnosis::runs
