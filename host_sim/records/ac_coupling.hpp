// Channels that have passed a high-pass of first order, as behind the amplifier of a piezo sensor or an AC-coupled input.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

struct AcCoupling {
  std::string channel;
  double corner_Hz = 0.0;
};

// What the channels read before their high-pass: y + wc * integral of y, wc = 2 pi corner, which undoes it exactly. What the
// integral makes of the sensor's zero and of its drift is not the signal's: its parabola over the record is taken off.
std::vector<double> before_ac_coupling(const std::vector<double>& reading, double corner_Hz, double sample_period_s);

// What the high-pass took away, over what is left; 0 where nothing is.
double share_taken(const std::vector<double>& reading, double corner_Hz, double sample_period_s);

// Undoes it in every channel of that name.
void undo_ac_coupling(const std::vector<AcCoupling>& couplings, std::vector<Record>& records);

// Those that the rig file states.
std::vector<AcCoupling> stated_ac_couplings(const rig_file::RigModel& model);

}  // namespace host_sim
