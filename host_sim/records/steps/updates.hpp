// Sensors that are read more often than they tell anything new: a staircase, one value over several rows.
#pragma once
#include <vector>

namespace host_sim {

// For how many rows a channel holds each value on the mean, while it moves; 1 where it does not hold them. resolution: the step of
// a quantised channel, else 0. Told by steps of four times the finest and more: what moves so far from one row to the next moves on
// in the row after, if each row is read anew, and at most one in four of noisy steps meets the same value again. Here more than
// 60 of 100 do, of 20 at least. An encoder that is crossed slowly steps by its finest step, a rest has no steps, and what jumps over
// half its range (a square wave) is no staircase.
double rows_per_update(const std::vector<double>& values, double resolution);

}  // namespace host_sim
