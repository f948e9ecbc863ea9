#include "host_sim/live/state/trend.hpp"

#include <cmath>

namespace live {

void Trend::add(uint64_t time_ns, double value, uint64_t span_ns) {
  if (!std::isfinite(value)) return;
  if (!points_.empty() && time_ns < points_.back().time_ns) points_.clear();  // the log began anew
  points_.push_back({time_ns, value});
  while (points_.front().time_ns + span_ns < time_ns) points_.pop_front();
  if (points_.size() <= kMostPoints) return;
  std::deque<TrendPoint> half;
  for (size_t i = points_.size() % 2 == 0 ? 1 : 0; i < points_.size(); i += 2)
    half.push_back(points_[i]);  // with the newest
  points_.swap(half);
}

}  // namespace live
