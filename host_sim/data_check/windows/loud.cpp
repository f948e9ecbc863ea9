#include "host_sim/data_check/windows/loud.hpp"

#include <algorithm>

namespace host_sim::data_check {

double loud_energy(const std::vector<double>& energy) {
  constexpr double kLoud = 0.05;  // of the largest
  return kLoud * *std::max_element(energy.begin(), energy.end());
}

bool decays_enough(const std::vector<double>& energy, const std::function<bool(size_t)>& is_in_decay) {
  constexpr double kShareOfIt = 0.25;  // of what is loud, at least
  const double loud = loud_energy(energy);
  size_t all = 0, in_decays = 0;
  for (size_t i = 0; i < energy.size(); ++i) {
    if (energy[i] <= loud) continue;
    ++all;
    in_decays += is_in_decay(i) ? 1 : 0;
  }
  return static_cast<double>(in_decays) > kShareOfIt * static_cast<double>(all);
}

}  // namespace host_sim::data_check
