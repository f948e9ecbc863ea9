// Curves as the path data of SVG, in tenths of a unit and relative steps: small, and the same on every machine.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace host_sim::reports {

struct Point {
  double x, y;  // a gap where either is not finite
};

// "M1 2.1l1.5-1 0 30": each point is rounded from where it is, so that errors do not add up. Closed: with a "z" at the
// end of every part.
std::string path_data(const std::vector<Point>& points, bool closed = false);

}  // namespace host_sim::reports
