// How much of a channel is white from row to row, at rows of any times.
#pragma once
#include <vector>

namespace host_sim {

// Variance of the white noise in x at the instants t_s, which rise. In the weights of a divided difference of order n, 1 over the product
// of (t_j - t_k) over all other rows k, a motion like a polynomial of lower degree is nothing whatever the steps are, and noise is as the
// root of the weights' squares: even steps make them binomial. Of orders 1 to 8 the one that makes the least of it. 0: of fewer rows than
// can tell (33).
double noise_variance(const std::vector<double>& x, const std::vector<double>& t_s);

}  // namespace host_sim
