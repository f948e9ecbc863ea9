#include "host_sim/reports/figures/path.hpp"

#include <cmath>
#include <cstdlib>

namespace host_sim::reports {
namespace {

// 12 -> "1.2", -5 -> "-.5", 30 -> "3"; with a blank in front where it would run into the number before.
void append_tenths(std::string& out, long tenths, bool first) {
  if (tenths >= 0 && !first) out += ' ';
  if (tenths < 0) out += '-';
  const long size = std::labs(tenths);
  if (size >= 10 || size == 0) out += std::to_string(size / 10);
  if (size % 10 != 0) out += "." + std::to_string(size % 10);
}

}  // namespace

std::string path_data(const std::vector<Point>& points, bool closed) {
  std::string out;
  long x = 0, y = 0;
  enum { kAway, kMoved, kDrawing } pen = kAway;
  for (const Point& point : points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
      if (closed && pen == kDrawing) out += 'z';
      pen = kAway;
      continue;
    }
    const long next_x = std::lround(10.0 * point.x), next_y = std::lround(10.0 * point.y);
    if (pen == kAway) {
      out += 'M';
      append_tenths(out, next_x, true);
      append_tenths(out, next_y, false);
      pen = kMoved;
    } else {
      if (pen == kMoved) out += 'l';
      append_tenths(out, next_x - x, pen == kMoved);
      append_tenths(out, next_y - y, false);
      pen = kDrawing;
    }
    x = next_x;
    y = next_y;
  }
  if (closed && pen == kDrawing) out += 'z';
  return out;
}

}  // namespace host_sim::reports
