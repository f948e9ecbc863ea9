#include "host_sim/records/csv/blanks/fill_blanks.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/records/times/even_times.hpp"
#include "host_sim/records/times/resample.hpp"

namespace host_sim {
namespace {

constexpr size_t kPoints = 4;

void fill(const std::vector<double>& time_s, std::vector<double>& values, FilledBlanks& result) {
  std::vector<size_t> there;
  std::vector<double> there_s;
  for (size_t row = 0; row < values.size(); ++row)
    if (!std::isnan(values[row])) there.push_back(row), there_s.push_back(time_s[row]);
  // where other columns end is not where this one does
  for (size_t row = 0; row < values.size(); ++row)
    if (there.empty() || row < there.front() || row > there.back()) result.keep[row] = false;
  if (there.size() < 2) return;
  const double longest = kLongestGap * median_step(there_s);
  for (size_t i = 1; i < there.size(); ++i) {
    const bool fills = there_s[i] - there_s[i - 1] <= longest;
    const size_t first = i >= 2 ? i - 2 : 0, points = std::min(i + 2, there.size()) - first;
    for (size_t row = there[i - 1] + 1; row < there[i]; ++row) {
      result.keep[row] = result.keep[row] && fills;
      if (!fills) continue;
      double weight[kPoints], value = values[there[i - 1]];
      weights_at(&there_s[first], points, time_s[row], weight);
      // from the value before on: where all are alike the sum is that value to the last bit
      for (size_t j = 0; j < points; ++j) value += weight[j] * (values[there[first + j]] - values[there[i - 1]]);
      values[row] = value;
      ++result.filled;
    }
  }
}

}  // namespace

double fastest_step(const std::vector<double>& time_s, const std::vector<TableColumn>& columns) {
  double fastest_s = 0.0;
  for (const TableColumn& column : columns) {
    std::vector<double> there_s;
    for (size_t row = 0; row < time_s.size(); ++row)
      if (!std::isnan((*column.values)[row])) there_s.push_back(time_s[row]);
    if (there_s.size() < 2) continue;
    const double step_s = median_step(there_s);
    fastest_s = fastest_s > 0.0 ? std::min(fastest_s, step_s) : step_s;
  }
  return fastest_s;
}

FilledBlanks fill_blanks(const std::vector<double>& time_s, const std::vector<TableColumn>& columns) {
  FilledBlanks result;
  result.keep.assign(time_s.size(), true);
  for (const TableColumn& column : columns) {
    if (std::none_of(column.values->begin(), column.values->end(), [](double v) { return std::isnan(v); })) continue;
    result.names += (result.names.empty() ? "" : ", ") + column.name;
    fill(time_s, *column.values, result);
  }
  result.left_out = static_cast<size_t>(std::count(result.keep.begin(), result.keep.end(), false));
  return result;
}

}  // namespace host_sim
