// What turns or rolls one way all along: it swings about no middle, and has no period.
#pragma once
#include <vector>

#include "host_sim/data_check/decay/decay_span.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

// Whether a velocity keeps its sign; at rest it may show its noise or its offset on the other side, up to a hundredth of the energy.
bool keeps_its_sign(const Channel& channel);

// The free decays of a record whose DOFs all keep the sign of their rate (a velocity, or an angle's slope): the energy is the
// square of the rate. Each is what follows a maximum, from where a twentieth of the energy is lost, until it rises again
// by a fifth; it has to fall to a quarter. A decay that begins with the record begins there, unless it is held at first:
// what coasts never loses energy more slowly the faster it is, so where the first twentieth takes three times as long as
// the next one, a motor held it. Empty where there is none such, or three quarters of the loud part of the record are none.
std::vector<DecaySpan> coasting_decays(const Record& record);

}  // namespace host_sim::data_check
