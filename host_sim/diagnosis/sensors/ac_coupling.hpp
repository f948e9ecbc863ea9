// A high-pass of first order in a channel: it takes wc times the integral of its signal away (wc = 2 pi corner), of an
// acceleration wc v. The rig's equations make a damper of that, of wc times the mass. Channels of one DOF show it without
// any equation: the derivative of a velocity is not behind it.
#pragma once
#include "../first_screen/rows_say.hpp"
#include "host_sim/records/ac_coupling.hpp"

namespace diagnosis {

// Corners of the channels that alone among the DOF's stand behind one, over all records.
std::vector<SensorFault> ac_couplings(const Asked& asked);

// Force channels as behind the high-pass of the accelerometers, which often share their make and amplifier; none where no
// accelerometer is.
std::vector<SensorFault> forces_coupled_alike(const std::vector<SensorFault>& found, const host_sim::Record& record);

// Whether the rig as given misses less of unseen data in the one diagnosis, by as much as names a cause (30 %).
bool pays_unseen(const Diagnosis& with, const Diagnosis& without);

// Whether all of them take less of their channels away than a calibration is wrong by.
bool all_small(const std::vector<SensorFault>& found, const host_sim::Record& record);

// Whether it pays to say so: unseen data are simulated better with them undone, or a number of the rig as given leaves its 95 % interval.
bool undoing_matters(const Diagnosis& undone, const Diagnosis& as_recorded);

// Beside what was found in records without them.
void name_ac_couplings(const std::vector<SensorFault>& found, Diagnosis& d);

// Those that it names.
std::vector<host_sim::AcCoupling> couplings_of(const Diagnosis& d);

}  // namespace diagnosis
