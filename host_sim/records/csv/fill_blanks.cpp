#include "host_sim/records/csv/fill_blanks.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/records/resample.hpp"

namespace host_sim {
namespace {

double usual_step(const std::vector<double>& time_s, const std::vector<size_t>& there) {
  std::vector<double> steps;
  for (size_t i = 1; i < there.size(); ++i) steps.push_back(time_s[there[i]] - time_s[there[i - 1]]);
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

// Lagrange through the points `there[first]` to `there[end - 1]`.
double through(const std::vector<double>& time_s, const std::vector<double>& values, const std::vector<size_t>& there,
               size_t first, size_t end, double t) {
  double sum = 0.0;
  for (size_t j = first; j < end; ++j) {
    double weight = 1.0;
    for (size_t k = first; k < end; ++k)
      if (k != j) weight *= (t - time_s[there[k]]) / (time_s[there[j]] - time_s[there[k]]);
    sum += weight * values[there[j]];
  }
  return sum;
}

void fill(const std::vector<double>& time_s, std::vector<double>& values, FilledBlanks& result) {
  std::vector<size_t> there;
  for (size_t row = 0; row < values.size(); ++row)
    if (!std::isnan(values[row])) there.push_back(row);
  // where other columns end is not where this one does
  for (size_t row = 0; row < values.size(); ++row)
    if (there.empty() || row < there.front() || row > there.back()) result.keep[row] = false;
  const double longest = kLongestGap * usual_step(time_s, there);
  for (size_t i = 1; i < there.size(); ++i) {
    const bool fills = time_s[there[i]] - time_s[there[i - 1]] <= longest;
    for (size_t row = there[i - 1] + 1; row < there[i]; ++row) {
      if (fills) {
        const size_t first = i >= 2 ? i - 2 : 0, end = std::min(i + 2, there.size());
        values[row] = through(time_s, values, there, first, end, time_s[row]);
        ++result.filled;
      } else {
        result.keep[row] = false;
      }
    }
  }
}

}  // namespace

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

void keep_only(const std::vector<bool>& keep, std::vector<double>& values) {
  size_t kept = 0;
  for (size_t row = 0; row < values.size(); ++row)
    if (keep[row]) values[kept++] = values[row];
  values.resize(kept);
}

}  // namespace host_sim
