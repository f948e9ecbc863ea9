#include "host_sim/records/times/in_order.hpp"

#include <algorithm>
#include <boost/sort/spreadsort/float_sort.hpp>
#include <cmath>
#include <cstdint>

namespace host_sim {
namespace {

constexpr size_t kFewest = 256, kMost = UINT32_MAX - 1;
constexpr uint32_t kCrowd = 24;  // values in one drawer

std::vector<double> compared(std::vector<double> values) {
  boost::sort::spreadsort::float_sort(values.begin(), values.end());
  return values;
}

// As many drawers as values, side by side over their range: nearly all hold one or two.
struct Drawers {
  std::vector<uint32_t> of;   // the drawer of each value
  std::vector<uint32_t> end;  // how many values are in the drawers before the k-th; one more at the end
  bool crowded = false;       // half of the values are in drawers with many others
};

Drawers drawers_of(const std::vector<double>& values, double lowest, double per_unit) {
  Drawers drawers;
  drawers.of.resize(values.size());
  drawers.end.resize(values.size() + 1);
  for (size_t i = 0; i < values.size(); ++i) {
    drawers.of[i] = static_cast<uint32_t>((values[i] - lowest) * per_unit);
    ++drawers.end[drawers.of[i] + 1];
  }
  size_t among_others = 0;
  for (size_t k = 1; k < drawers.end.size(); ++k) {
    if (drawers.end[k] > kCrowd) among_others += drawers.end[k];
    drawers.end[k] += drawers.end[k - 1];
  }
  drawers.crowded = 2 * among_others > values.size();
  return drawers;
}

void put_in_order(double* first, double* last) {
  if (last - first > static_cast<std::ptrdiff_t>(kCrowd)) return std::sort(first, last);
  for (double* next = first + 1; next < last; ++next) {
    const double value = *next;
    double* at = next;
    for (; at != first && at[-1] > value; --at) *at = at[-1];
    *at = value;
  }
}

}  // namespace

std::vector<double> in_order(const std::vector<double>& values) {
  if (values.size() < kFewest || values.size() > kMost) return compared(values);
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double per_unit = static_cast<double>(values.size() - 1) / (*highest - *lowest);
  if (!std::isfinite(per_unit)) return compared(values);
  Drawers drawers = drawers_of(values, *lowest, per_unit);
  if (drawers.crowded) return compared(values);
  std::vector<double> sorted(values.size());
  for (size_t i = 0; i < values.size(); ++i) sorted[drawers.end[drawers.of[i]]++] = values[i];  // now where each ends
  uint32_t first = 0;
  for (size_t k = 0; k < values.size(); first = drawers.end[k++])
    put_in_order(sorted.data() + first, sorted.data() + drawers.end[k]);
  return sorted;
}

}  // namespace host_sim
