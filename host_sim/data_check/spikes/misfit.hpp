// How far samples lie off what their neighbours lead to.
#pragma once
#include <cstddef>
#include <vector>

namespace host_sim::data_check {

// What each sample is off the cubic through the two before and the two behind it, unit of the values; 0 at the two ends.
std::vector<double> misfits(const std::vector<double>& x);

// The usual misfit around `width` samples from i on, they and their nearest left out, as the standard deviation of noise.
double usual_near(const std::vector<double>& misfit, size_t i, size_t width);

// Does the motion beside the stretch, on one side at least, swing so fast that its stretches stand off as this one does? A ringing
// of a few samples a period, such as a chatter, is no row of spikes.
bool is_of_a_ringing(const std::vector<double>& misfit, size_t first, size_t width);

}  // namespace host_sim::data_check
