// Positions that count over: an encoder or a servo that reads -pi to pi, or any other whole turn, as one motion without jumps.
#pragma once
#include "host_sim/records/record.hpp"

namespace host_sim {

// Every displacement or angle of the record that jumps by one and the same period, against the direction in which it goes on before
// and after, has its turns joined, and a note says by what and how often. Nothing where a jump may be anything else: a motion that
// stands, or turns round, on both sides of most jumps (a square wave, a dropout), jumps of several sizes, a range beyond the period,
// or one jump alone that is no whole turn of 2 pi.
void join_turns(Record& record);

}  // namespace host_sim
