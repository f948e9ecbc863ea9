// Running integrals of channels, each made once.
#pragma once
#include <map>
#include <utility>
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

// Running integrals of channels, once and twice, by trapezoids and in steps, means taken off: made when they are first asked for, as
// each channel is compared with many. The channels outlive this.
class Integrals {
 public:
  const std::vector<double>& of(const Channel& channel, bool twice);

 private:
  std::map<std::pair<const Channel*, bool>, std::vector<double>> made_;
};

}  // namespace host_sim::data_check
