#include "host_sim/data_check/one_motion/integrals.hpp"

#include <Eigen/Core>

namespace host_sim::data_check {

const std::vector<double>& Integrals::of(const Channel& channel, bool twice) {
  const auto [entry, fresh] = made_.try_emplace({&channel, twice});
  std::vector<double>& sums = entry->second;
  if (!fresh) return sums;
  const std::vector<double>& values = twice ? of(channel, false) : channel.values;
  const double mean = Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size())).mean();
  sums.resize(values.size());
  double sum = 0.0;
  for (size_t i = 0; i < values.size(); ++i) {
    const double half = 0.5 * (values[i] - mean);
    sums[i] = sum += half;
    sum += half;
  }
  return sums;
}

}  // namespace host_sim::data_check
