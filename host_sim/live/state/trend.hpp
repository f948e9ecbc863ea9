// What an estimate did over the last minutes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>

namespace live {

struct TrendPoint {
  uint64_t time_ns = 0;
  double value = 0.0;
};

// The newest points, up to `span` before the last; where there are too many, every second one is forgotten.
class Trend {
 public:
  static constexpr size_t kMostPoints = 2048;

  void add(uint64_t time_ns, double value, uint64_t span_ns);
  const std::deque<TrendPoint>& points() const { return points_; }

 private:
  std::deque<TrendPoint> points_;
};

}  // namespace live
