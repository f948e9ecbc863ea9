#include "host_sim/live/screen/trend_line.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace live {
namespace {

const char* const kBlocks[] = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
const char* const kLetters[] = {"_", ".", "-", "=", "+", "*", "%", "#"};
constexpr int kLevels = 8;

struct Range {
  double low, high;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The first windows of a run are far off: what is far from the median is drawn at the edge, and the rest keeps its shape.
Range shown_range(const std::vector<double>& values, double std) {
  constexpr double kReach = 6.0;  // median absolute deviations; four standard deviations of normal noise
  std::vector<double> finite, distances;
  for (const double value : values)
    if (std::isfinite(value)) finite.push_back(value);
  if (finite.empty()) return {0.0, 0.0};
  const double middle = median(finite);
  for (const double value : finite) distances.push_back(std::fabs(value - middle));
  const double reach = std::max(2.0 * std, kReach * median(distances));
  Range range{*std::min_element(finite.begin(), finite.end()), *std::max_element(finite.begin(), finite.end())};
  if (reach > 0.0) range = {std::max(range.low, middle - reach), std::min(range.high, middle + reach)};
  const double missing = 4.0 * std - (range.high - range.low);
  if (missing > 0.0) range = {range.low - 0.5 * missing, range.high + 0.5 * missing};
  return range;
}

// The last value of each column; a column without one repeats the column before.
std::vector<double> values_of_columns(const Trend& trend, uint64_t begin_ns, uint64_t end_ns, int columns) {
  const double duration_ns = std::max(1.0, static_cast<double>(end_ns - begin_ns));
  std::vector<double> values(static_cast<size_t>(columns), NAN);
  double before = NAN;  // the last value ahead of what is shown
  for (const TrendPoint& point : trend.points()) {
    if (point.time_ns < begin_ns) {
      before = point.value;
      continue;
    }
    const double place = static_cast<double>(point.time_ns - begin_ns) / duration_ns * columns;
    values[static_cast<size_t>(std::min(columns - 1, static_cast<int>(place)))] = point.value;
  }
  for (double& value : values) before = value = std::isfinite(value) ? value : before;
  return values;
}

}  // namespace

std::string trend_line(const Trend& trend, double std, uint64_t now_ns, uint64_t span_ns, int columns, bool unicode) {
  if (columns <= 0) return "";
  if (trend.points().empty()) return std::string(static_cast<size_t>(columns), ' ');
  const uint64_t end_ns = std::max(now_ns, trend.points().back().time_ns);
  const uint64_t begin_ns = std::max(trend.points().front().time_ns, end_ns > span_ns ? end_ns - span_ns : 0);
  const std::vector<double> values = values_of_columns(trend, begin_ns, end_ns, columns);
  const Range range = shown_range(values, std);
  std::string text;
  for (const double value : values) {
    if (!std::isfinite(value)) {
      text += ' ';
      continue;
    }
    const double height = range.high > range.low ? (value - range.low) / (range.high - range.low) : 0.5;
    const int level = std::clamp(static_cast<int>(height * kLevels), 0, kLevels - 1);
    text += unicode ? kBlocks[level] : kLetters[level];
  }
  return text;
}

}  // namespace live
