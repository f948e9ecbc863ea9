#include "host_sim/data_check/bell.hpp"

namespace host_sim::data_check {

std::vector<double> bell(const std::vector<double>& y, int k, size_t h, double sample_period_s) {
  std::vector<double> values = y;
  const double span = static_cast<double>(h);
  for (int box = 0; box < kBoxes; ++box) {
    std::vector<double> next(values.size() > h ? values.size() - h : 0);
    double sum = 0.0;
    for (size_t i = 0; i < h && i < values.size(); ++i) sum += values[i];
    for (size_t i = 0; i < next.size(); ++i) {
      next[i] = box < k ? (values[i + h] - values[i]) / (span * sample_period_s)
                        : (sum + 0.5 * (values[i + h] - values[i])) / span;
      sum += values[i + h] - values[i];
    }
    values = std::move(next);
  }
  return values;
}

}  // namespace host_sim::data_check
