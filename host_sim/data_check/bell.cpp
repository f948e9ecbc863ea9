#include "host_sim/data_check/bell.hpp"

namespace host_sim::data_check {

std::vector<double> bell(const std::vector<double>& y, int k, size_t h, double sample_period_s) {
  std::vector<double> values = y;
  const double span = static_cast<double>(h);
  for (int box = 0; box < kBoxes; ++box) {  // in place: a value is read before it is written over
    const size_t count = values.size() > h ? values.size() - h : 0;
    if (box < k) {
      for (size_t i = 0; i < count; ++i) values[i] = (values[i + h] - values[i]) / (span * sample_period_s);
    } else {
      double sum = 0.0;
      for (size_t i = 0; i < h && i < values.size(); ++i) sum += values[i];
      for (size_t i = 0; i < count; ++i) {
        const double change = values[i + h] - values[i];
        values[i] = (sum + 0.5 * change) / span;
        sum += change;
      }
    }
    values.resize(count);
  }
  return values;
}

}  // namespace host_sim::data_check
