#include "host_sim/reports/figures/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace host_sim::reports {
namespace {

struct Column {
  size_t lowest, highest;  // index of the smallest and the largest value
};

Column extremes(const std::vector<double>& y, size_t first, size_t last) {
  Column column{first, first};
  for (size_t i = first; i < last; ++i) {
    if (y[i] < y[column.lowest] || !std::isfinite(y[column.lowest])) column.lowest = i;
    if (y[i] > y[column.highest] || !std::isfinite(y[column.highest])) column.highest = i;
  }
  return column;
}

double quantile(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<long>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Samples per mean period, between upward crossings of the mean with a dead band of a tenth of the rms.
double mean_period(const std::vector<double>& y) {
  const double count = static_cast<double>(y.size());
  const double mean = std::accumulate(y.begin(), y.end(), 0.0) / count;
  double square = 0.0;
  for (double value : y) square += (value - mean) * (value - mean);
  const double dead = 0.1 * std::sqrt(square / count);
  size_t crossings = 0;
  bool armed = false;
  for (double value : y) {
    if (value - mean < -dead) armed = true;
    if (armed && value - mean > dead) {
      ++crossings;
      armed = false;
    }
  }
  return crossings ? count / static_cast<double>(crossings) : count;
}

}  // namespace

Curve envelope_line(const std::vector<double>& y, Span span, double start_s, double period_s, size_t columns) {
  Curve curve;
  const auto add = [&](size_t i) {
    curve.x.push_back(start_s + static_cast<double>(i) * period_s);
    curve.y.push_back(y[i]);
  };
  if (span.count <= 2 * columns) {
    for (size_t i = span.first; i < span.first + span.count; ++i) add(i);
    return curve;
  }
  for (size_t c = 0; c < columns; ++c) {
    const Column column =
        extremes(y, span.first + c * span.count / columns, span.first + (c + 1) * span.count / columns);
    add(std::min(column.lowest, column.highest));
    if (column.lowest != column.highest) add(std::max(column.lowest, column.highest));
  }
  return curve;
}

Curve envelope_band(const std::vector<double>& y, Span span, double start_s, double period_s, size_t columns) {
  Curve curve;
  curve.shape = Shape::kBand;
  columns = std::min(columns, span.count);
  for (size_t c = 0; c < columns; ++c) {
    const size_t first = span.first + c * span.count / columns, last = span.first + (c + 1) * span.count / columns;
    const Column column = extremes(y, first, last);
    curve.x.push_back(start_s + 0.5 * static_cast<double>(first + last - 1) * period_s);
    curve.y.push_back(y[column.lowest]);
    curve.y_high.push_back(y[column.highest]);
  }
  return curve;
}

Binned binned(const std::vector<double>& x, const std::vector<double>& y, size_t bins) {
  Binned out;
  if (x.empty() || x.size() != y.size()) return out;
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const double width = (*high - *low) / static_cast<double>(bins);
  if (!(width > 0.0)) return out;
  std::vector<std::vector<double>> content(bins);
  for (size_t i = 0; i < x.size(); ++i)
    if (std::isfinite(y[i])) content[std::min(bins - 1, static_cast<size_t>((x[i] - *low) / width))].push_back(y[i]);
  for (size_t b = 0; b < bins; ++b) {
    if (content[b].size() < 5) continue;
    out.x.push_back(*low + (static_cast<double>(b) + 0.5) * width);
    out.median.push_back(quantile(content[b], 0.5));
    out.low.push_back(quantile(content[b], 0.1));
    out.high.push_back(quantile(content[b], 0.9));
  }
  return out;
}

Span most_different(const std::vector<double>& a, const std::vector<double>& b, double cycles) {
  const size_t samples = a.size();
  if (samples < 2) return {0, samples};
  const double period = mean_period(a);
  const double wanted = std::min(cycles * period, std::max(2.0 * period, 0.25 * static_cast<double>(samples)));
  const size_t count = std::clamp<size_t>(static_cast<size_t>(wanted), std::min<size_t>(samples, 40), samples);
  if (b.size() != samples) return {0, count};
  double sum = 0.0, best = -1.0;
  size_t best_first = 0;
  for (size_t i = 0; i < samples; ++i) {
    const double in = a[i] - b[i];
    sum += in * in;
    if (i >= count) sum -= (a[i - count] - b[i - count]) * (a[i - count] - b[i - count]);
    if (i + 1 >= count && sum > best) {
      best = sum;
      best_first = i + 1 - count;
    }
  }
  return {best_first, count};
}

}  // namespace host_sim::reports
