// What two causes would bring together.
#pragma once
#include "gains.hpp"

namespace diagnosis::runs {

// Best first. `chosen`: candidates of one column; what is of one kind and place is not paired.
std::vector<ScreenedPair> pair_gains(const System& system, const std::vector<Prepared>& records, const Model& model,
                                     const std::vector<Window>& windows, const Fitted& fit,
                                     const std::vector<Candidate>& candidates, const std::vector<size_t>& chosen,
                                     const Gains& gains, double residual_square);

}  // namespace diagnosis::runs
