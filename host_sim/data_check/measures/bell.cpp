#include "host_sim/data_check/measures/bell.hpp"

namespace host_sim::data_check {

std::vector<double> bell(const std::vector<double>& y, int k, size_t h, double sample_period_s) {
  std::vector<double> values = y;
  const double span = static_cast<double>(h), per_time = 1.0 / (span * sample_period_s), per_span = 1.0 / span;
  for (int box = 0; box < kBoxes; ++box) {  // in place: a value is read before it is written over
    const size_t count = values.size() > h ? values.size() - h : 0;
    if (box < k) {
      for (size_t i = 0; i < count; ++i) values[i] = (values[i + h] - values[i]) * per_time;
    } else {
      double sum = 0.0;
      for (size_t i = 0; i < h && i < values.size(); ++i) sum += values[i];
      for (size_t i = 0; i < count; ++i) {
        const double change = values[i + h] - values[i];
        values[i] = (sum + 0.5 * change) * per_span;
        sum += change;
      }
    }
    values.resize(count);
  }
  return values;
}

std::vector<double> twice_as_wide(const std::vector<double>& thinned) {
  constexpr double kBinomial[kBoxes + 1] = {1.0 / 64, 6.0 / 64, 15.0 / 64, 20.0 / 64, 15.0 / 64, 6.0 / 64, 1.0 / 64};
  std::vector<double> wider(thinned.size() > kBoxes ? (thinned.size() - kBoxes) / 2 : 0);
  for (size_t i = 0; i < wider.size(); ++i)
    for (size_t k = 0; k <= kBoxes; ++k) wider[i] += kBinomial[k] * thinned[2 * i + k];
  return wider;
}

}  // namespace host_sim::data_check
